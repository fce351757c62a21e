// SPDX-License-Identifier: MIT
// A design as the fragment of a link: "#v1=" and base64url of the deflated payload.

import { fromBase64Url, toBase64Url } from "../bytes/base64url.ts";
import { deflate, inflate } from "../bytes/deflate.ts";
import { type Result, refuse } from "../result/result.ts";
import { decodePayload, encodePayload } from "./payload.ts";
import type { Recipe } from "./recipe.ts";
import { DAMAGED_LINK } from "./refusal.ts";

const PREFIX = "#v1=";

/** Bytes. No browser opens a link as long as one that packs more than this. */
const LARGEST = 32 * 1024 * 1024;

/** The fragment for `recipe`, "#" included. */
export const encodeLink = async (recipe: Recipe): Promise<string> =>
  PREFIX + toBase64Url(await deflate(await encodePayload(recipe)));

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function decodeLink(hash: string): Promise<Result<Recipe>> {
  const version = /^#v(\d{1,9})=/.exec(hash)?.[1];
  if (version === undefined) return refuse("This is not a link to a design.");
  if (version !== "1") {
    return refuse(
      `This link is of version ${version}; this page reads version 1. Reload the page.`,
    );
  }
  const packed = fromBase64Url(hash.slice(PREFIX.length));
  const bytes = packed && (await inflate(packed, LARGEST).catch(() => null));
  const recipe = bytes && decodePayload(bytes);
  return recipe ? { ok: true, value: recipe } : DAMAGED_LINK;
}

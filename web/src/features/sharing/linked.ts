// SPDX-License-Identifier: MIT
// What a link says: the text of a design, or what version 1 packed.

import { unpackLink } from "../../design/link.ts";
import type { Steps } from "../../design/recipe.ts";
import { decodeLink, PREFIX } from "../../design/v1/link.ts";
import { done, type Result, refuse } from "../../result/result.ts";
import { enqueue } from "../../state/action-queue.ts";
import { readText } from "../../state/design-text.ts";
import type { Page } from "../../state/page.ts";

const NOT_READ = refuse("The link was not read.");

async function readDesign(page: Page, text: string): Promise<Result<Steps>> {
  const read = await readText(page, "reading the link", text);
  if (!read.ok) return read.reason ? read : NOT_READ;
  const { source, ...steps } = read.value;
  if (!source) return refuse("The mesh of this link lies beside it. Open the mesh as a file.");
  return done({ ...steps, source });
}

/** Any string gives a recipe or a sentence that says what is wrong with it; it never throws. */
export async function readLink(page: Page, hash: string): Promise<Result<Steps>> {
  if (hash.startsWith(PREFIX)) return decodeLink(hash);
  const text = await unpackLink(hash);
  if (!text.ok) return text;
  let read: Result<Steps> = NOT_READ;
  await enqueue(page, async () => {
    read = await readDesign(page, text.value);
    return undefined;
  });
  return read;
}

// SPDX-License-Identifier: MIT
// A design as text in the fragment of a link: "#d1=" and base64url of its zlib-compressed JSON, which
// scripts write (docs/formats.md). The core reads the text, as it reads a file.

import { fromBase64Url } from "../bytes/base64url.ts";
import { inflate } from "../bytes/deflate.ts";
import { type Result, refuse } from "../result/result.ts";
import { DAMAGED_LINK } from "./refusal.ts";

const PREFIX = "#d1=";

/** Bytes; what a design may have as a file. */
const LARGEST = 64 * 1024 * 1024;

export const isTextLink = (hash: string): boolean => hash.startsWith("#d");

/** The design's JSON or a sentence; zlib's checksum finds what was changed on the way. */
export async function unpackText(hash: string): Promise<Result<string>> {
  if (!hash.startsWith(PREFIX))
    return refuse("This link is of another version than this page reads. Reload the page.");
  const packed = fromBase64Url(hash.slice(PREFIX.length));
  const bytes = packed && (await inflate(packed, LARGEST, "deflate").catch(() => null));
  if (!bytes) return DAMAGED_LINK;
  return { ok: true, value: new TextDecoder().decode(bytes) };
}

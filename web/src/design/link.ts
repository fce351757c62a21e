// SPDX-License-Identifier: MIT
// A design's text as the fragment of a link: "#v2=" and base64url of its JSON, which zlib compressed, by the
// core's link dictionary or by none. "#d1=" is the same without one.

import { linkDictionary } from "virtual:core-defaults";
import { fromBase64Url, toBase64Url } from "../bytes/base64url.ts";
import { compress, decompress } from "../bytes/zlib.ts";
import { type Result, refuse } from "../result/result.ts";
import { DAMAGED_LINK } from "./refusal.ts";

const PREFIX = "#v2=";

/** Bytes; what a design may have as a file. */
const LARGEST = 64 * 1024 * 1024;

const dictionary = (): Uint8Array => new TextEncoder().encode(linkDictionary);

/** The fragment for a design's text, "#" included. */
export const packLink = (text: string): string =>
  PREFIX + toBase64Url(compress(new TextEncoder().encode(text), dictionary()));

/** The design's JSON or a sentence; never throws. zlib's checksum finds what was changed on the way. */
export async function unpackLink(hash: string): Promise<Result<string>> {
  const [start = "", kind, version] = /^#([dv])(\d{1,9})=/.exec(hash) ?? [];
  if (!start) return refuse("This is not a link to a design.");
  if (start !== PREFIX && start !== "#d1=") {
    const known = kind === "v" ? "versions 1 and 2" : "version 1";
    return refuse(`This link is of version ${version}; this page reads ${known}. Reload the page.`);
  }
  const packed = fromBase64Url(hash.slice(start.length));
  const bytes = packed && (await decompress(packed, dictionary(), LARGEST).catch(() => null));
  return bytes ? { ok: true, value: new TextDecoder().decode(bytes) } : DAMAGED_LINK;
}

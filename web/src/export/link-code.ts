// SPDX-License-Identifier: MIT
// A link as a QR code: the core's LinkCode, the same as the command line draws.
import { encode } from "uqr";
import type { LinkCode } from "../solver/protocol.ts";

/** As in core/include/planish/fabrication/labels.hpp: with these the standard leaves one answer. */
const FIXED = { ecc: "M", boostEcc: false, maskPattern: 2, maxVersion: 30, border: 0 } as const;

/** A link and its code; without a code where the link is too long for one. */
export function linkCode(link: string): LinkCode {
  if (link === "") return { link, size: 0, dark: [] };
  try {
    const { size, data } = encode([...new TextEncoder().encode(link)], FIXED);
    return { link, size, dark: data.flat().map(Number) };
  } catch {
    return { link, size: 0, dark: [] };
  }
}

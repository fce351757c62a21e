// SPDX-License-Identifier: MIT
// Build only: the typeface with the characters, weights and features that the page uses. A name in
// another script falls back to the system's sans.
import subsetFont from "subset-font";
import type { Plugin } from "vite";

const range = (from: number, to: number): string =>
  String.fromCodePoint(...Array.from({ length: to - from + 1 }, (_, k) => from + k));

/** ASCII, and the punctuation and signs of the page's own words. */
const CHARACTERS = `${range(0x20, 0x7e)}\u00a0°±²³µ·×÷§©«»äöüÄÖÜßéèàç–—‘’“”…←→↑↓−≈≤≥`;

export function smallFont(): Plugin {
  return {
    name: "small-font",
    apply: "build",
    async generateBundle(_, bundle) {
      for (const item of Object.values(bundle)) {
        if (item.type !== "asset" || !item.fileName.endsWith(".woff2")) continue;
        item.source = await subsetFont(Buffer.from(item.source), CHARACTERS, {
          targetFormat: "woff2",
          variationAxes: { wght: { min: 400, max: 650 } },
          keepFeatures: ["kern", "tnum", "cv05", "ss03", "ccmp", "calt"],
          noHinting: true,
        });
      }
    },
  };
}

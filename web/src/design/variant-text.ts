// SPDX-License-Identifier: MIT
// A variant beside a design: its name (n) and, as a design's JSON has it, what was done to the same source.
import { isRecord, type Json, LONGEST_NAME } from "./reading.ts";

export type VariantJson = Json & { readonly n: string };

/** @param text of the variant as a design of its own */
export function variantJson(name: string, text: string): VariantJson {
  const { format: _, version: __, source: ___, unit: ____, ...steps } = JSON.parse(text) as Json;
  return { n: name.slice(0, LONGEST_NAME), ...steps };
}

/** The variant as a design of its own, of whatever source; null if it is no object. */
export function variantText(value: unknown): string | null {
  if (!isRecord(value)) return null;
  const { n: _, ...steps } = value;
  const format = { format: "planish-design", version: 1, source: { file: "" } };
  return JSON.stringify({ ...steps, ...format });
}

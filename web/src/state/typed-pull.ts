// SPDX-License-Identifier: MIT
// A length that is typed while points are dragged says how far they go; the pointer, which way.
import { parseLength } from "../quantity/expression.ts";
import type { Page } from "./page.ts";

/** What a key makes of what was typed before; null: the key is none of a length. */
function typedOn(typed: string, key: string): string | null {
  if (/^[0-9]$/.test(key)) return typed + key;
  if (key === "." || key === ",") return typed.includes(".") ? typed : `${typed}.`;
  if (key === "-") return typed.startsWith("-") ? typed.slice(1) : `-${typed}`;
  return key === "Backspace" && typed !== "" ? typed.slice(0, -1) : null;
}

/** False where no drag goes on, or the key is none of a length. */
export function typePull(page: Page, key: string): boolean {
  const pull = page.pull.value;
  const typed = pull && typedOn(pull.typed, key);
  if (!pull || typed === null) return false;
  page.pull.value = { ...pull, typed };
  return true;
}

/** Model units; null while no number is typed. Less than 0: against the way of the pointer. */
export function typedPull(page: Page): number | null {
  const length = parseLength(page.pull.value?.typed ?? "", 0, page.unit.value);
  return length.ok ? length.value : null;
}

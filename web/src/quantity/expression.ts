// SPDX-License-Identifier: MIT
// What may be typed into a coordinate field: "1200", "1.2m", "3*400mm", "+50" and "-=50" (relative).
import type { Result } from "../result/result.ts";
import { convert, isUnit, type Unit } from "./units.ts";

type Token =
  | { kind: "number"; value: number }
  | { kind: "unit"; unit: Unit }
  | { kind: "mark"; mark: string };

const TOKEN =
  /\s*(?:(\d+(?:[.,]\d*)?(?:e[+-]?\d+)?|[.,]\d+(?:e[+-]?\d+)?)|([a-z]+|"|')|([-+*/()]))/iy;

function tokenize(text: string): Token[] | string {
  const tokens: Token[] = [];
  TOKEN.lastIndex = 0;
  while (TOKEN.lastIndex < text.trimEnd().length) {
    const start = TOKEN.lastIndex;
    const match = TOKEN.exec(text);
    if (!match) return `"${text.slice(start).trim()}" is not a number.`;
    const [, number, word, mark] = match;
    if (number) tokens.push({ kind: "number", value: Number(number.replace(",", ".")) });
    else if (mark) tokens.push({ kind: "mark", mark });
    else if (word) {
      const unit = word === '"' ? "in" : word === "'" ? "ft" : word.toLowerCase();
      if (!isUnit(unit)) return `"${word}" is not a unit. Use mm, cm, m, km, in or ft.`;
      tokens.push({ kind: "unit", unit });
    }
  }
  return tokens;
}

/** Precedence climbing over the tokens; a bare number is in the field's unit. */
class Reader {
  readonly #tokens: readonly Token[];
  readonly #unit: Unit;
  #at = 0;

  constructor(tokens: readonly Token[], unit: Unit) {
    this.#tokens = tokens;
    this.#unit = unit;
  }

  get finished(): boolean {
    return this.#at >= this.#tokens.length;
  }

  sum(): number {
    let value = this.#product();
    for (;;) {
      if (this.#take("+")) value += this.#product();
      else if (this.#take("-")) value -= this.#product();
      else return value;
    }
  }

  #product(): number {
    let value = this.#signed();
    for (;;) {
      if (this.#take("*")) value *= this.#signed();
      else if (this.#take("/")) value /= this.#signed();
      else return value;
    }
  }

  #signed(): number {
    if (this.#take("-")) return -this.#signed();
    if (this.#take("+")) return this.#signed();
    return this.#operand();
  }

  #operand(): number {
    let value = Number.NaN;
    const token = this.#tokens[this.#at];
    if (token?.kind === "number") {
      this.#at += 1;
      value = token.value;
    } else if (this.#take("(")) {
      value = this.sum();
      if (!this.#take(")")) return Number.NaN;
    }
    const next = this.#tokens[this.#at];
    if (next?.kind !== "unit") return value;
    this.#at += 1;
    return convert(value, next.unit, this.#unit);
  }

  #take(mark: string): boolean {
    const token = this.#tokens[this.#at];
    if (token?.kind !== "mark" || token.mark !== mark) return false;
    this.#at += 1;
    return true;
  }
}

/** Places may be less than 0, so that a minus alone is a sign, and "-=" takes away. */
const RELATIVE = /^\s*(?:([+-])=|(?=\+))/;

/** The length that `text` means, in `unit`. What begins with "+", "+=" or "-=" is relative to `current`. */
export function parseLength(text: string, current: number, unit: Unit): Result<number> {
  if (text.trim() === "") return { ok: false, reason: "Type a number." };
  const relative = RELATIVE.exec(text);
  const tokens = tokenize(text.slice(relative?.[0].length ?? 0));
  if (typeof tokens === "string") return { ok: false, reason: tokens };
  const reader = new Reader(tokens, unit);
  const value = reader.sum();
  if (!reader.finished || !Number.isFinite(value)) {
    return { ok: false, reason: `"${text.trim()}" is not a number.` };
  }
  if (!relative) return { ok: true, value };
  return { ok: true, value: relative[1] === "-" ? current - value : current + value };
}

// SPDX-License-Identifier: MIT
import type { Answer } from "./planish_package.mjs";

/** usage: an option, a handle or a name is wrong; mesh: a mesh, a design or a file cannot be used. */
export type ErrorKind = "usage" | "mesh" | "internal";

/** What can go wrong, in one sentence that names the field. */
export class PlanishError extends Error {
  override readonly name = "PlanishError";
  readonly kind: ErrorKind;

  constructor(kind: ErrorKind, sentence: string) {
    super(sentence);
    this.kind = kind;
  }
}

/** "--keep-boundary" as it is written here: keepBoundary. */
export const camelCase = (option: string): string =>
  option.replace(/^--?/, "").replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());

/** The core's sentence with the names of options as they are written here. */
export const wording = (sentence: string): string =>
  sentence.replace(/--[a-z][a-z-]*/g, (option) => camelCase(option));

/** The value of an answer; throws a PlanishError where there is none. */
export function insist<T>(answer: Answer<T>): T {
  if (answer.kind === undefined) return answer.value;
  throw new PlanishError(answer.kind, wording(answer.sentence));
}

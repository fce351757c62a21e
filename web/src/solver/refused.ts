// SPDX-License-Identifier: MIT
// What the session refuses, and what it dies of.
import { aboutFile } from "./reading.ts";

/** Raised by an operation that the session refused; its message is for the user. */
export class Refused extends Error {}

const NO_MEMORY = "There is not enough memory for this mesh in the browser.";

export function insist(refusal: string): void {
  if (refusal) throw new Refused(refusal);
}

export function insistReadable(name: string, refusal: string): void {
  insist(refusal && refusal !== NO_MEMORY ? aboutFile(name, refusal) : refusal);
}

/** Whether the module's memory is full or in no known state after `error`. */
export const isFatal = (error: unknown): boolean =>
  error instanceof WebAssembly.RuntimeError ||
  error instanceof RangeError ||
  (error instanceof Refused && error.message === NO_MEMORY);

/** What an error says to the user. */
export function sentence(error: unknown): string {
  // "OOM" is how the module's allocator ends.
  if (error instanceof WebAssembly.RuntimeError && !error.message.includes("OOM"))
    return "The solver stopped unexpectedly. Your last finished design is back.";
  if (isFatal(error)) return `${NO_MEMORY} Your last finished design is back.`;
  return error instanceof Error ? error.message : String(error);
}

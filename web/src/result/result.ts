// SPDX-License-Identifier: MIT
// What comes of something that can fail for reasons that are nobody's bug: a value, or what to say.

export interface Refusal {
  readonly ok: false;
  /** A sentence for whoever asked; "" where there is nothing to say: it was given up. */
  readonly reason: string;
}

export type Result<T> = { readonly ok: true; readonly value: T } | Refusal;

export const done = <T>(value: T): Result<T> => ({ ok: true, value });

export const refuse = (reason: string): Refusal => ({ ok: false, reason });

export const GIVEN_UP = refuse("");

// SPDX-License-Identifier: MIT
// What a design that came from outside is refused with.

export interface Refusal {
  readonly ok: false;
  readonly reason: string;
}

export const refuse = (reason: string): Refusal => ({ ok: false, reason });

export const DAMAGED_LINK = refuse(
  "This link is damaged: part of it is missing or was changed. Ask for it again.",
);

// SPDX-License-Identifier: MIT

/** "1 panel", "3 panels". */
export const counted = (n: number, what: string): string =>
  n === 1 ? `1 ${what}` : `${n} ${what}s`;

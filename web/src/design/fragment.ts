// SPDX-License-Identifier: MIT
/** Whether a fragment claims to be a design, packed (v) or as text (d), of whatever version. */
export const isLink = (hash: string): boolean => /^#[dv]\d+=/.test(hash);

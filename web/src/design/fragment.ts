// SPDX-License-Identifier: MIT
/** Whether a fragment claims to be a design, of the page (v) or of a script (d), of whatever version. */
export const isLink = (hash: string): boolean => /^#[dv]\d+=/.test(hash);

// SPDX-License-Identifier: MIT
/** Whether a fragment claims to be a design, of whatever version. */
export const isLink = (hash: string): boolean => /^#v\d+=/.test(hash);

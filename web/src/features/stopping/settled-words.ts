// SPDX-License-Identifier: MIT
import { formatLength, type Unit } from "../../quantity/units.ts";
import type { Settling } from "../../state/settling.ts";

/** Of the pull: what a drag may end by otherwise than its last frame, and nobody sees it. */
const AS_SHOWN = 0.01;

/** What the end of a drag changed in the shape that its last frame showed; null where it is the same. */
export const settledWords = ({ most, pull }: Settling, unit: Unit): string | null =>
  most > AS_SHOWN * pull
    ? `As it settled, points moved by up to ${formatLength(most, unit)}.`
    : null;

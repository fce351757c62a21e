// SPDX-License-Identifier: MIT
// How an edit's folds are told, and which limits are of those that an edit gets unasked (find_fair_limits() of the core).

import { buildableCorners } from "virtual:core-defaults";
import type { ShapeReport } from "./protocol.ts";

/** Of the limits that the page finds itself, all are multiples of it. */
const STEP = 10;
/** Degrees by which a fold at a limit may seem to exceed it. */
const ROUNDING = 0.01;

/** How many degrees the fold that sharpened most became sharper. */
export const foldGrowth = ({ sharpestFold: fold }: ShapeReport): number =>
  fold ? (fold.growth ?? fold.after - fold.before) : 0;

/** Degrees: of the limits that the page finds the first that folds grown by as much keep. */
export const stepOf = (growth: number): number =>
  STEP * Math.max(1, Math.ceil((growth - ROUNDING) / STEP));

/** Whether a limit is one that the page finds, where nobody stated it. */
export const isFound = (limit: string, stated: readonly string[]): boolean =>
  (limit === buildableCorners || /^fold=\+\d*0$/.test(limit)) && !stated.includes(limit);

// SPDX-License-Identifier: MIT
import type { ShapeReport } from "./protocol.ts";

/** The limits that hold an edit back, by the core's names: at each there is a panel, or a point. */
export const boundNames = ({ bounds }: ShapeReport): readonly string[] =>
  Object.entries(bounds ?? {}).flatMap(([name, held]) => (held.length > 0 ? [name] : []));

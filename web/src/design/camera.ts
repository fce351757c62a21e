// SPDX-License-Identifier: MIT
import type { Point } from "./design.ts";

/** Where a view looks from; display coordinates. */
export interface Camera {
  readonly position: Point;
  readonly target: Point;
}

export interface NamedView {
  /** No two have the same. */
  readonly name: string;
  readonly camera: Camera;
}

// SPDX-License-Identifier: MIT
// What a session tells of a cut that is tried out, see bindings.cpp.

/** What one more cut would leave. */
export interface CutTrial {
  /** Why it cannot be made; "" where it can. */
  readonly problem: string;
  /** It, and under a symmetry its images, as --cut says them, one a line. */
  readonly cuts: string;
  /** x, y, z of both ends of every new side where the design shown has them, display coordinates. */
  readonly lines: Float32Array;
}

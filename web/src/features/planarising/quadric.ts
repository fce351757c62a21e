// SPDX-License-Identifier: MIT
// How a surface bends about a place: the quadric that fits points best, by least squares.

/** Terms of a quadric: 1, x, y, x², x y, y². */
const TERMS = 6;

const ROW = TERMS + 1;

/** Of the largest pivot: below, the points do not tell (they lie on a line, or on a conic). */
const LEAST_PIVOT = 1e-9;

/** Normal equations, which grow by one point after the other. */
export class Quadric {
  readonly #sums = new Float64Array(TERMS * ROW);
  readonly #terms = new Float64Array(ROW);

  clear(): void {
    this.#sums.fill(0);
  }

  /** Of height `h` over (x, y); all of about 1. */
  add(x: number, y: number, h: number): void {
    const [sums, terms] = [this.#sums, this.#terms];
    terms.set([1, x, y, x * x, x * y, y * y, h]);
    for (let i = 0; i < TERMS; ++i) {
      const term = terms[i] ?? 0;
      for (let j = 0; j < ROW; ++j)
        sums[i * ROW + j] = (sums[i * ROW + j] ?? 0) + term * (terms[j] ?? 0);
    }
  }

  /** Second derivatives along x, across, along y; null where the points do not tell. Uses up the sums. */
  hessian(): readonly [xx: number, xy: number, yy: number] | null {
    const s = this.#sums;
    for (let k = 0; k < TERMS; ++k) {
      // Symmetric and not negative: no exchange of rows is needed.
      const pivot = s[k * ROW + k] ?? 0;
      if (pivot < LEAST_PIVOT) return null;
      for (let i = 0; i < TERMS; ++i) {
        const factor = i === k ? 0 : (s[i * ROW + k] ?? 0) / pivot;
        for (let j = k; factor !== 0 && j < ROW; ++j)
          s[i * ROW + j] = (s[i * ROW + j] ?? 0) - factor * (s[k * ROW + j] ?? 0);
      }
    }
    const at = (k: number): number => (s[k * ROW + TERMS] ?? 0) / (s[k * ROW + k] ?? 1);
    return [2 * at(3), at(4), 2 * at(5)];
  }
}

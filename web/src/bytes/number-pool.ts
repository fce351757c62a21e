// SPDX-License-Identifier: MIT
// The float64 numbers of a record, bit for bit, and the places in JSON that refer to them.

/** First number and how many. */
export type Place = readonly [number, number];

export class PoolWriter {
  readonly #parts: ArrayLike<number>[] = [];
  #length = 0;

  add(numbers: ArrayLike<number>): Place {
    const place: Place = [this.#length, numbers.length];
    this.#parts.push(numbers);
    this.#length += numbers.length;
    return place;
  }

  /** Little-endian, as every browser's typed arrays are. */
  bytes(): Uint8Array {
    const all = new Float64Array(this.#length);
    let at = 0;
    for (const part of this.#parts) {
      all.set(part, at);
      at += part.length;
    }
    return new Uint8Array(all.buffer);
  }
}

export class PoolReader {
  readonly #numbers: Float64Array;
  /** Every number belongs to one place, so that a record cannot ask for more than it brings. */
  #left: number;

  /** `bytes` may start anywhere; a length that is no whole number of float64 is cut. */
  constructor(bytes: Uint8Array) {
    const whole = bytes.length - (bytes.length % 8);
    this.#numbers = new Float64Array(bytes.slice(0, whole).buffer);
    this.#left = this.#numbers.length;
  }

  /** A copy of what `place` refers to; null if it is no place, lies outside or is used up. */
  at(place: unknown): Float64Array | null {
    if (!Array.isArray(place) || place.length !== 2) return null;
    const [start, count] = place as unknown[];
    if (!Number.isInteger(start) || !Number.isInteger(count)) return null;
    const [from, size] = [start as number, count as number];
    if (from < 0 || size < 0 || from + size > this.#numbers.length) return null;
    if (size > this.#left) return null;
    this.#left -= size;
    return this.#numbers.slice(from, from + size);
  }
}

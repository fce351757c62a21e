// SPDX-License-Identifier: MIT
interface Uploaded {
  addUpdateRange(start: number, count: number): void;
  needsUpdate: boolean;
}

/** The stretch of a buffer that changed since it was last sent to the graphics card. */
export class DirtyRange {
  #low = Number.POSITIVE_INFINITY;
  #high = -1;

  add(item: number): void {
    if (item < this.#low) this.#low = item;
    if (item > this.#high) this.#high = item;
  }

  addAll(items: number): void {
    if (items === 0) return;
    this.add(0);
    this.add(items - 1);
  }

  /** Marks what changed for upload; `size` numbers belong to an item. */
  flush(buffer: Uploaded, size: number): void {
    if (this.#high < this.#low) return;
    buffer.addUpdateRange(size * this.#low, size * (this.#high - this.#low + 1));
    buffer.needsUpdate = true;
    this.#low = Number.POSITIVE_INFINITY;
    this.#high = -1;
  }
}

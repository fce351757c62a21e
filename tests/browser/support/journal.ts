// SPDX-License-Identifier: MIT
// What the page's journal should be: the exported file after every step, kept outside the page.

export interface Entry {
  readonly obj: string;
  /** The file as it was when the mesh was opened: what "untouched" means. */
  readonly base: string;
  /** False while a mesh waits for being planarised. */
  readonly flat: boolean;
}

export class Journal {
  #past: Entry[] = [];
  #future: Entry[] = [];
  present: Entry;

  constructor(present: Entry) {
    this.present = present;
  }

  get canUndo(): boolean {
    return this.#past.length > 0;
  }

  get canRedo(): boolean {
    return this.#future.length > 0;
  }

  step(next: Entry): void {
    this.#past = [...this.#past, this.present].slice(-200);
    this.present = next;
    this.#future = [];
  }

  undo(): void {
    const previous = this.#past.pop();
    if (!previous) return;
    this.#future.unshift(this.present);
    this.present = previous;
  }

  redo(): void {
    const next = this.#future.shift();
    if (!next) return;
    this.#past.push(this.present);
    this.present = next;
  }

  /** A reload keeps the present alone. */
  forget(): void {
    this.#past = [];
    this.#future = [];
  }
}

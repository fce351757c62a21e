// SPDX-License-Identifier: MIT

/** The elements that are drawn over the canvas for one purpose: as many as there is to show. */
export class ElementPool {
  readonly #elements: HTMLElement[] = [];
  readonly #add: () => HTMLElement;

  /** `add` puts a new element into its layer. */
  constructor(add: () => HTMLElement) {
    this.#add = add;
  }

  resize(count: number): void {
    while (this.#elements.length < count) this.#elements.push(this.#add());
    for (const surplus of this.#elements.splice(count)) surplus.remove();
  }

  at(k: number): HTMLElement | undefined {
    return this.#elements[k];
  }
}

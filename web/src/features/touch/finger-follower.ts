// SPDX-License-Identifier: MIT
// A finger that drags a point, and the drag that it made, are followed by what helps with both.

import type { Place } from "../../scene/picking.ts";
import type { Sight } from "../../scene/sight.ts";
import type { Outcome } from "../../state/action-queue.ts";
import { fetchPart } from "../../state/later.ts";
import type { FingerHelp } from "./finger-help.ts";

export class FingerFollower {
  readonly #sight: Sight;
  #help: FingerHelp | null = null;
  /** null until it is asked for. */
  #coming: Promise<void> | null = null;
  #finger: Place | null = null;

  constructor(sight: Sight) {
    this.#sight = sight;
  }

  /** The finger is here, pixels of the canvas; null: it is lifted. */
  follow(finger: Place | null): void {
    this.#finger = finger;
    if (!finger) this.#help?.hide();
    else if (this.#coming) this.#sight.stage.invalidate();
    else this.#coming = this.#fetch();
  }

  async #fetch(): Promise<void> {
    const part = await fetchPart(this.#sight.page, () => import("./finger-help.ts"));
    if (part && this.#coming) this.#help = new part.FingerHelp(this.#sight);
    // What could not be had is asked for again.
    else this.#coming = null;
    this.#sight.stage.invalidate();
  }

  /** The finger that dragged this point was lifted; the drag ends so. */
  async lifted(vertex: number, ended: Outcome): Promise<void> {
    await this.#coming;
    await this.#help?.lifted(vertex, ended);
  }

  /** The view was drawn. */
  draw(): void {
    this.#help?.draw(this.#finger);
  }

  dispose(): void {
    this.#coming = null;
    this.#help?.dispose();
    this.#help = null;
  }
}

// SPDX-License-Identifier: MIT
// What a finger that drags points is helped by: a loupe while it does, and after it a way to take the
// drag back. Fetched with the first such drag.

import { type Place, project } from "../../scene/picking.ts";
import type { Sight } from "../../scene/sight.ts";
import type { Outcome } from "../../state/action-queue.ts";
import {
  type FingerDrag,
  fingerDrag,
  offerPlace,
  offerToTakeBack,
} from "../../state/finger-drag.ts";
import { clearOfPoint, OFFER, type Size } from "./clear-of-point.ts";
import { Loupe } from "./loupe.ts";

export class FingerHelp {
  readonly #sight: Sight;
  readonly #loupe: Loupe;
  /** The drag whose buttons have their place. */
  #offered: FingerDrag | null = null;

  constructor(sight: Sight) {
    this.#sight = sight;
    this.#loupe = new Loupe(sight.canvas);
  }

  /** The finger is lifted. */
  hide(): void {
    this.#loupe.hide();
  }

  /** The finger that dragged a point was lifted; the drag ends so. */
  async lifted(vertex: number, ended: Outcome): Promise<void> {
    await offerToTakeBack(this.#sight.page, vertex, ended);
    this.#sight.stage.invalidate();
  }

  /** The view was drawn. @param finger pixels of the canvas; null: there is none */
  draw(finger: Place | null): void {
    const { shell, page } = this.#sight;
    if (!shell) return;
    const view = this.#sight.view();
    const at = (vertex: number): Place | null => project(shell.current, vertex, view);
    if (finger)
      this.#loupe.draw(
        finger,
        page.selection.value.map(at).filter((mark) => mark !== null),
      );
    this.#placeOffer(at, view);
  }

  /** Places the offer; its buttons stay where they are while the camera turns. */
  #placeOffer(at: (vertex: number) => Place | null, view: Size): void {
    const drag = fingerDrag(this.#sight.page).value;
    if (drag === this.#offered) return;
    this.#offered = drag;
    const point = drag && (at(drag.vertex) ?? { x: 0, y: 0 });
    offerPlace(this.#sight.page).value = point && clearOfPoint(point, OFFER, view);
  }

  dispose(): void {
    this.#loupe.dispose();
  }
}

// SPDX-License-Identifier: MIT
// The line of the reach lies around what is pulled, or about to be, and its knob sets the reach.

import { effect, untracked } from "@preact/signals";
import { cleanView } from "../state/clean-view.ts";
import { commitSettings, previewSettings } from "../state/editing.ts";
import { hiddenPanels } from "../state/hidden-panels.ts";
import { putAt } from "./overlay.ts";
import type { Place } from "./picking.ts";
import { followKnob } from "./reach-knob.ts";
import { ReachLine } from "./reach-line.ts";
import type { Sight } from "./sight.ts";

export class ReachFollower {
  readonly #sight: Sight;
  readonly #knob: HTMLElement;
  readonly #line = new ReachLine();

  constructor(sight: Sight, knob: HTMLElement) {
    this.#sight = sight;
    this.#knob = knob;
  }

  /** Returns how to stop. */
  follow(): () => void {
    const stop = effect(() => this.#draw());
    const { page, canvas, stage } = this.#sight;
    stage.aids.add(this.#line.object);
    const off = followKnob(this.#knob, canvas, {
      move: (place) => this.#drag(place),
      end: () =>
        void commitSettings(page, { reach: page.settings.value?.reach ?? 0, reachLength: 0 }),
    });
    return () => {
      stop();
      off();
      stage.aids.delete(this.#line.object);
      this.#line.dispose();
    };
  }

  /** Another structure is shown. */
  layAnew(): void {
    this.#sight.shell?.group.add(this.#line.object);
    this.#line.forget();
    untracked(() => this.#draw());
  }

  /** Puts the knob where the camera sees the line. */
  placeKnob(): void {
    const { shell } = this.#sight;
    if (shell) putAt(this.#knob, this.#line.knob(shell, this.#sight.view()));
  }

  setColour(colour: string): void {
    this.#line.setColour(colour);
  }

  setSize(width: number, height: number): void {
    this.#line.setSize(width, height);
  }

  #draw(): void {
    const { page, shell, stage } = this.#sight;
    const [limits, opened] = [page.settings.value, page.mesh.value];
    if (!shell || !limits || !opened || page.displayMesh.value !== opened) return;
    const pulled = page.handles.value.flatMap(({ vertex, pinned }) => (pinned ? [] : [vertex]));
    const chosen = page.selected.value;
    const next = chosen === null || !page.baseFlat.value ? [] : [chosen];
    const length = limits.reachLength * opened.report.scale;
    // Around panels that are out of the picture the line would lead through the air.
    const shown = hiddenPanels(page).value.size === 0 && !cleanView(page).value;
    const seeds = !shown ? [] : pulled.length > 0 ? pulled : next;
    this.#line.draw(shell, seeds, { rings: limits.reach, length });
    stage.invalidate();
  }

  #drag(place: Place): void {
    const { page, shell } = this.#sight;
    if (!shell) return;
    const reach = this.#line.ringsAt(shell, place, this.#sight.view());
    if (reach !== page.settings.peek()?.reach) previewSettings(page, { reach, reachLength: 0 });
  }
}

// SPDX-License-Identifier: MIT
// Numbers of panels and points follow the view and the state.
import { effect } from "@preact/signals";
import { hiddenPanels } from "../state/hidden-panels.ts";
import { numbered } from "../state/numbering.ts";
import type { Page } from "../state/page.ts";
import { NumberLabels } from "./number-labels.ts";
import type { Viewport } from "./viewport.ts";

/** Milliseconds without a picture after which others are chosen. */
const REST = 120;

class NumberFollower {
  readonly #page: Page;
  readonly #view: Viewport;
  #labels: NumberLabels | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(page: Page, view: Viewport) {
    this.#page = page;
    this.#view = view;
  }

  /** The state changed. */
  update(): void {
    const { panels, points } = numbered(this.#page).value;
    hiddenPanels(this.#page).value;
    this.#page.displayMesh.value;
    if (panels || points) {
      this.#labels ??= new NumberLabels(this.#page, this.#view.stage.renderer.domElement);
      this.#choose();
    } else this.dispose();
  }

  /** The view was drawn. */
  draw(): void {
    const { shell } = this.#view.sight;
    if (!this.#labels || !shell) return;
    this.#labels.place(shell, this.#view.sight.view());
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#choose(), REST);
  }

  dispose(): void {
    clearTimeout(this.#timer);
    this.#labels?.dispose();
    this.#labels = null;
  }

  #choose(): void {
    const { sight } = this.#view;
    if (sight.shell) this.#labels?.choose(sight.shell, sight.view(), numbered(this.#page).peek());
  }
}

/** Returns how to stop. */
export function followNumbers(page: Page, view: Viewport): () => void {
  const follower = new NumberFollower(page, view);
  const stops = [effect(() => follower.update()), view.stage.onDrawn(() => follower.draw())];
  return () => {
    for (const stop of stops) stop();
    follower.dispose();
  };
}

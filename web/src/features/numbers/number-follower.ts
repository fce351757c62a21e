// SPDX-License-Identifier: MIT
// Numbers of panels and points follow the view and the state.
import { effect } from "@preact/signals";
import type { View } from "../../scene/picking.ts";
import { placedAlong } from "../../scene/placing.ts";
import type { Viewport } from "../../scene/viewport.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import type { Page } from "../../state/page.ts";
import { sectionPlane } from "../../state/shown-section.ts";
import { type Cut, NumberLabels } from "./number-labels.ts";
import { numbered } from "./numbering.ts";

/** Milliseconds without a turn of the camera after which others are chosen. */
const REST = 120;

/** What the section takes out of the picture. */
function cutOf(page: Page): Cut {
  const [plane, mesh] = [sectionPlane(page).peek(), page.mesh.peek()];
  if (!plane || !mesh) return null;
  const { axis, at, flipped } = plane;
  const height = placedAlong(axis, at, mesh.report);
  return (place) =>
    flipped ? place.getComponent(axis) < height : place.getComponent(axis) > height;
}

const from = ({ camera, width, height }: View): string =>
  [width, height, ...camera.matrixWorld.elements, ...camera.projectionMatrix.elements].join(" ");

class NumberFollower {
  readonly #page: Page;
  readonly #view: Viewport;
  #labels: NumberLabels | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** From where those that are shown were chosen. */
  #chosenFrom = "";

  constructor(page: Page, view: Viewport) {
    this.#page = page;
    this.#view = view;
  }

  /** The state changed. */
  update(): void {
    const { panels, points } = numbered(this.#page).value;
    hiddenPanels(this.#page).value;
    sectionPlane(this.#page).value;
    this.#page.displayMesh.value;
    this.#page.history.value;
    if (panels || points) {
      this.#labels ??= new NumberLabels(this.#page, this.#view.stage.renderer.domElement);
      this.#choose();
    } else this.dispose();
  }

  /** The view was drawn. */
  draw(): void {
    const { shell } = this.#view.sight;
    if (!this.#labels || !shell) return;
    const view = this.#view.sight.view();
    this.#labels.place(shell, view);
    if (from(view) === this.#chosenFrom) return;
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
    if (!sight.shell) return;
    const view = sight.view();
    this.#chosenFrom = from(view);
    this.#labels?.choose(sight.shell, view, numbered(this.#page).peek(), cutOf(this.#page));
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

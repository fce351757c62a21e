// SPDX-License-Identifier: MIT
// The 3D view: puts its parts together, has them follow the state, and does what keys and buttons ask.

import { effect, untracked } from "@preact/signals";
import { type Object3D, Vector3 } from "three";
import { cleanView } from "../state/clean-view.ts";
import { frameAt } from "../state/dragging.ts";
import { handleOf } from "../state/editing.ts";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";
import { panelsAtLimit } from "../state/refused-pull.ts";
import { deselect } from "../state/selection.ts";
import { askedPulls } from "./asked-pulls.ts";
import { followColours } from "./colour-follower.ts";
import { followers } from "./followers.ts";
import type { ViewName } from "./framing.ts";
import { Gizmo } from "./gizmo.ts";
import { grip, holdOf } from "./grip.ts";
import { boxesOver, type LowerCorners, wholeOf } from "./held-in-view.ts";
import { Overlay, type OverlayParts } from "./overlay.ts";
import { DARK, LIGHT, type Palette } from "./palette.ts";
import type { Box } from "./picking.ts";
import { watchPixelRatio } from "./pixel-ratio.ts";
import { PointerTool } from "./pointer.ts";
import { PointerChoice } from "./pointer-choice.ts";
import { ReachFollower } from "./reach-follower.ts";
import { Sight } from "./sight.ts";
import { Stage } from "./stage.ts";
import { followStructure } from "./structure-follower.ts";
import { viewTool } from "./view-tool.ts";

export interface ViewportParts extends OverlayParts, LowerCorners {
  readonly canvas: HTMLCanvasElement;
  /** On the line of the reach. */
  readonly knob: HTMLElement;
}

export class Viewport {
  readonly stage: Stage;
  readonly #page: Page;
  readonly #parts: ViewportParts;
  readonly sight: Sight;
  readonly #gizmo: Gizmo;
  readonly #choice: PointerChoice;
  readonly #pointer: PointerTool;
  readonly #overlay: Overlay;
  readonly #reach: ReachFollower;
  readonly #dark = window.matchMedia("(prefers-color-scheme: dark)");
  readonly #stop: (() => void)[] = [];

  constructor(page: Page, parts: ViewportParts) {
    this.#page = page;
    this.#parts = parts;
    this.#overlay = new Overlay(page, parts);
    this.stage = new Stage(parts.canvas, {
      before: (pixel) => this.sight.shell?.inkEdges(pixel),
      after: () => this.#placeOverlay(),
    });
    this.sight = new Sight(page, parts.canvas, this.stage);
    this.#gizmo = new Gizmo(this.stage);
    this.#reach = new ReachFollower(this.sight, parts.knob);
    this.#choice = new PointerChoice(this.sight, this.#gizmo);
    this.#pointer = this.#makePointer();
    this.#follow();
  }

  /** The group of the structure on the stage; null before there is one. */
  readonly structure = (): Object3D | null => this.sight.shell?.group ?? null;

  view(name: ViewName): void {
    const { shell } = this.sight;
    if (shell) this.stage.view(name, wholeOf(shell), this.#over(), false);
  }

  /** Brings what is selected, or the whole design, into view without turning the camera. */
  async fit(all: boolean): Promise<void> {
    const part = all ? null : await fetchPart(this.#page, () => import("./chosen-subject.ts"));
    const { shell } = this.sight;
    if (!shell) return;
    const chosen = part?.chosenOf(this.#page, shell);
    this.stage.fit(chosen ?? wholeOf(shell), this.#over());
  }

  /** Gives up a drag, or drawing around points, or what a tool has begun; without either, deselects. */
  escape(): void {
    const [drawing, tool] = [this.#page.areaTool.value !== null, viewTool(this.#page).peek()];
    if (this.#pointer.dragging || drawing) this.#pointer.abandon();
    else if (tool) tool.escape();
    else deselect(this.#page);
    this.#page.areaTool.value = null;
  }

  turn(right: number, down: number): void {
    this.stage.turn(right * 0.12, down * 0.12, this.sight.leader());
  }

  zoom(factor: number): void {
    this.stage.zoom(factor);
  }

  /** Goes to the nearest point in a direction on screen; `also` keeps what was chosen. */
  stepSelection(right: number, down: number, also: boolean): void {
    this.#choice.step(right, down, also);
  }

  picture(): Promise<Blob | null> {
    this.stage.drawClean();
    return new Promise((resolve) => this.#parts.canvas.toBlob(resolve, "image/png"));
  }

  dispose(): void {
    for (const stop of this.#stop) stop();
    this.#pointer.dispose();
    this.#gizmo.dispose();
    this.sight.shell?.dispose();
    this.sight.shell = null; // its shadow may still be to come
    this.stage.dispose();
  }

  #over(): Box[] {
    return boxesOver(this.#page, this.#parts.canvas, this.#parts);
  }

  #makePointer(): PointerTool {
    const [choice, sight, tool] = [this.#choice, this.sight, viewTool(this.#page)];
    return new PointerTool(this.#page, this.#parts.canvas, this.stage, {
      find: (x, y, coarse) => (tool.peek() ? null : choice.find(x, y, coarse)),
      area: () => this.#page.areaTool.value,
      hover: (hold, at) => {
        if (choice.hover(hold)) this.#placeOverlay();
        tool.peek()?.hover(at);
      },
      click: (x, y, hold, press) => {
        const used = tool.peek();
        if (used) used.click({ x, y }, press.coarse);
        else choice.click(x, y, hold, press);
      },
      double: (x, y, how) => {
        if (!tool.peek()) void choice.line({ x, y }, how);
      },
      grab: (hold, press) => grip(sight, hold, press),
      turn: (x, y) => this.stage.turnAbout(sight.leader() ?? sight.surfaceAt({ x, y })),
      zoom: (x, y) => {
        const at = sight.surfaceAt({ x, y });
        if (at) this.stage.aim(at);
      },
      drag: (session, keys, ray) => session.move(holdOf(sight, keys), ray),
      finger: (at) => {
        sight.finger.value = at;
      },
      lifted: ({ vertex }, ended) => {
        sight.lifted.value = { vertex, ended };
      },
      outline: (outline) => this.#overlay.drawOutline(outline),
      choose: (outline, also) => choice.area(outline, also),
    });
  }

  #palette(): Palette {
    return this.#dark.matches ? DARK : LIGHT;
  }

  #recolour(): void {
    const palette = this.#palette();
    this.stage.setPalette(palette);
    this.sight.shell?.setPalette(palette);
    this.#reach.setColour(palette.ghost);
  }

  /** Starts the followers, in this order: a new structure stands before anything is drawn on it. */
  #follow(): void {
    const palette = (): Palette => this.#palette();
    this.#stop.push(
      this.#watchWindow(),
      followStructure(this.sight, palette, {
        making: () => this.#beginAnew(),
        made: (shown, kept) => {
          const subject = { points: shown.display, edges: shown.topology.edges };
          if (!kept) this.stage.view("Perspective", subject, this.#over(), true);
        },
        moved: () => this.#showMoved(),
      }),
      followColours(this.sight),
      ...followers(this.#page).map((follow) => follow(this.sight, palette)),
      this.#reach.follow(),
      this.#followPanels(),
      this.#followPoints(),
    );
    this.#recolour();
  }

  #watchWindow(): () => void {
    const recolour = (): void => this.#recolour();
    this.#dark.addEventListener("change", recolour);
    const observer = new ResizeObserver(() => this.#resize());
    observer.observe(this.#parts.canvas);
    const unwatch = watchPixelRatio(() => this.#resize());
    return () => {
      this.#dark.removeEventListener("change", recolour);
      observer.disconnect();
      unwatch();
    };
  }

  /** Outlines of panels, and the edit or what was before it. */
  #followPanels(): () => void {
    const stops = [
      effect(() => {
        this.#outline();
        const atLimit = panelsAtLimit(this.#page).value;
        this.sight.shell?.markLimits(cleanView(this.#page).value ? [] : atLimit);
        this.stage.invalidate();
      }),
      effect(() => void this.#lookAt(this.#page.selectedPanel.value)),
      effect(() => {
        this.#showBase();
        this.#overlay.showPulls(!this.#page.showBefore.value);
        this.stage.moved();
      }),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }

  /** Marks, pulls and arrows at points. */
  #followPoints(): () => void {
    const stops = [
      effect(() => {
        this.#overlay.update();
        this.#placeGizmo();
        this.#overlay.setPulls(cleanView(this.#page).value ? [] : askedPulls(this.#page));
        this.stage.invalidate();
      }),
      effect(() => {
        this.#gizmo.show(this.#page.lock.value);
        untracked(() => this.#pointer.refresh());
        this.stage.invalidate();
      }),
    ];
    return () => {
      for (const stop of stops) stop();
    };
  }

  #showBase(): void {
    this.sight.shell?.showBase(this.#page.showBefore.value, cleanView(this.#page).value);
  }

  /** The panel chosen, with its figure; neither in a clean view. */
  #outline(): void {
    const panel = this.#page.selectedPanel.value;
    const shown = cleanView(this.#page).value ? null : panel;
    this.#overlay.setPanel(this.sight.shell?.outlinePanel(shown) ?? null);
  }

  /** Brings a panel to the middle, near enough to judge it; turns the view only if it must. */
  async #lookAt(panel: number | null): Promise<void> {
    const corners = panel === null ? null : this.sight.shell?.cornersOf(panel);
    if (!corners || this.#choice.choosing) return;
    const part = await fetchPart(this.#page, () => import("./panel-look.ts"));
    const shown = this.#page.displayMesh.peek();
    if (!part || !shown || panel !== this.#page.selectedPanel.peek()) return;
    this.stage.glideTo(part.closer(this.stage.camera, this.stage.orbit, corners, shown));
  }

  #beginAnew(): void {
    this.#reach.layAnew();
    this.#overlay.setPanel(null);
    this.#showBase();
    this.#resize();
  }

  #showMoved(): void {
    if (this.#page.selectedPanel.peek() !== null) untracked(() => this.#outline());
    this.#placeGizmo();
    this.stage.moved();
  }

  #resize(): void {
    const { width, height } = this.#parts.canvas.getBoundingClientRect();
    this.stage.resize(width, height);
    this.sight.shell?.setSize(width, height);
    this.#reach.setSize(width, height);
    this.#gizmo.resize(height);
  }

  /** Arrows stand in the middle of the chosen points that are not pinned; the last of them leads. */
  #placeGizmo(): void {
    const [{ shell }, page] = [this.sight, this.#page];
    const usable = page.ready.value && page.draft.value && !cleanView(page).value;
    const loose = page.selection.value.filter((v) => !handleOf(page, v)?.pinned);
    const leader = loose.at(-1);
    if (leader === undefined || !shell || !usable) {
      this.#gizmo.detach();
      return;
    }
    const turned = page.localArrows.value || page.lock.value?.axis === "normal";
    const middle = new Vector3();
    for (const v of loose) middle.add(new Vector3().fromArray(shell.current, 3 * v));
    this.#gizmo.attach(middle.divideScalar(loose.length), turned ? frameAt(page, leader) : null);
  }

  #placeOverlay(): void {
    const { shell } = this.sight;
    if (!shell) return;
    this.#overlay.place(shell.current, shell.base, this.sight.view());
    this.#reach.placeKnob();
  }
}

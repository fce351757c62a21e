// SPDX-License-Identifier: MIT
// One of several designs seen at once, by cameras that go together.

import type { Camera } from "../../design/camera.ts";
import { prepareDisplay } from "../../mesh/display-mesh.ts";
import { DARK, LIGHT } from "../../scene/palette.ts";
import { Shell } from "../../scene/shell.ts";
import { Stage } from "../../scene/stage.ts";
import type { OpenedMesh, Shape } from "../../solver/protocol.ts";
import { displayOfShape } from "../../solver/shape-display.ts";

const dark = window.matchMedia("(prefers-color-scheme: dark)");

/** What its colours are held against: the mesh, or another design of it. */
function baseOf(opened: OpenedMesh, against: Shape | null): OpenedMesh {
  if (!against) return opened;
  const { offsets, vertices } = opened;
  const display = displayOfShape(opened, against);
  return { ...opened, ...prepareDisplay({ display, offsets, vertices }) };
}

export class CompareView {
  readonly #stage: Stage;
  readonly #canvas: HTMLCanvasElement;
  readonly #watch: ResizeObserver;
  #shell: Shell | null = null;

  constructor(canvas: HTMLCanvasElement) {
    this.#canvas = canvas;
    this.#stage = new Stage(canvas, {
      before: (pixel) => this.#shell?.inkEdges(pixel),
      after: () => {},
    });
    this.#stage.setPalette(dark.matches ? DARK : LIGHT);
    this.#watch = new ResizeObserver(() => this.#resize());
    this.#watch.observe(canvas);
  }

  /** Shows a design, coloured by how far it is from `against`, or from its mesh. */
  show(opened: OpenedMesh, shape: Shape, against: Shape | null): void {
    this.#shell?.dispose();
    const shell = new Shell(baseOf(opened, against), dark.matches ? DARK : LIGHT);
    const points = displayOfShape(opened, shape);
    const changes: number[] = [];
    for (let v = 0; v < points.length / 3; ++v) {
      const [x = 0, y = 0, z = 0] = points.subarray(3 * v, 3 * v + 3);
      const [p, q, r] = shell.base.subarray(3 * v, 3 * v + 3);
      if (x !== p || y !== q || z !== r) changes.push(v, x, y, z);
    }
    shell.apply(Float32Array.from(changes));
    this.#shell = shell;
    this.#resize();
    this.#stage.setSubject(shell.group, shell.bounds());
    this.#stage.castShadows();
  }

  /** Display units. */
  get largest(): number {
    return this.#shell?.largest ?? 0;
  }

  scaleTo(largest: number): void {
    this.#shell?.scaleTo(largest);
    this.#stage.invalidate();
  }

  place(camera: Camera): void {
    this.#stage.place(camera);
  }

  read(): Camera {
    return this.#stage.read();
  }

  /** Moves on with `other`, whatever turned it. */
  follow(other: CompareView): void {
    const [mine, theirs] = [this.#stage, other.#stage];
    mine.camera.position.copy(theirs.camera.position);
    mine.camera.quaternion.copy(theirs.camera.quaternion);
    mine.camera.fov = theirs.camera.fov;
    mine.orbit.target.copy(theirs.orbit.target);
    mine.camera.updateProjectionMatrix();
    mine.invalidate();
  }

  onTurn(turned: () => void): void {
    this.#stage.orbit.addEventListener("change", turned);
  }

  dispose(): void {
    this.#watch.disconnect();
    this.#shell?.dispose();
    this.#stage.dispose();
  }

  #resize(): void {
    const { width, height } = this.#canvas.getBoundingClientRect();
    this.#stage.resize(width, height);
    this.#shell?.setSize(width, height);
    this.#stage.invalidate();
  }
}

/** The views move as one. */
export function linkViews(views: readonly CompareView[]): void {
  for (const view of views) {
    view.onTurn(() => {
      for (const other of views) if (other !== view) other.follow(view);
    });
  }
}

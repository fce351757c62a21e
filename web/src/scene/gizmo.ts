// SPDX-License-Identifier: MIT
// Arrows and small planes at the chosen point, or in the middle of several. They only show where one can pull; the pointer
// tool does the pulling, so that every drag is held and snapped in one way. They are fetched with
// the first chosen point: the first drag does not wait for them.
import { type BufferGeometry, Matrix4, Mesh, Object3D, Vector3 } from "three";
import type { TransformControls } from "three/addons/controls/TransformControls.js";
import type { Frame } from "../mesh/point-frame.ts";
import type { Lock } from "../state/page-state.ts";
import type { Arrow } from "./constraint.ts";
import type { Stage } from "./stage.ts";

/** Which of the gizmo's own axes a part moves along, or across for a plane. */
const PARTS: Readonly<Record<string, readonly [number, boolean]>> = {
  X: [0, false],
  Y: [1, false],
  Z: [2, false],
  YZ: [0, true],
  XZ: [1, true],
  XY: [2, true],
};

/** The size that TransformControls calls 1 grows with the view; this gives arrows of 64 pixels. */
const ARROWS = 450;

const AXIS_OF: Readonly<Record<string, number>> = { X: 0, Y: 1, Z: 2 };

/** An arrow each way at every axis is more than a point needs. */
function dropBackArrows(controls: TransformControls): void {
  const back: Object3D[] = [];
  controls.getHelper().traverse((part) => {
    if (!(part instanceof Mesh) || !(part.name in AXIS_OF)) return;
    const { geometry } = part as Mesh<BufferGeometry>;
    geometry.computeBoundingBox();
    const reach = geometry.boundingBox?.max.getComponent(AXIS_OF[part.name] ?? 0) ?? 0;
    if (reach < 0.1) back.push(part);
  });
  for (const part of back) part.removeFromParent();
}

export class Gizmo {
  #controls: TransformControls | null = null;
  #asked = false;
  #wanted = false;
  #lock: Lock | null = null;
  #height = 720;
  readonly #proxy = new Object3D();
  readonly #stage: Stage;

  constructor(stage: Stage) {
    this.#stage = stage;
    stage.scene.add(this.#proxy);
  }

  async #fetch(): Promise<void> {
    if (this.#asked) return;
    this.#asked = true;
    const { TransformControls } = await this.#stage.expecting(
      import("three/addons/controls/TransformControls.js"),
    );
    if (!this.#asked) return;
    const controls = new TransformControls(this.#stage.camera, null);
    controls.setSize(this.#size());
    controls.setSpace("local");
    controls.setColors("#C2453A", "#3C8A4E", "#2F5FD0", "#F2B134");
    dropBackArrows(controls);
    this.#stage.scene.add(controls.getHelper());
    this.#stage.aids.add(controls.getHelper());
    this.#controls = controls;
    this.show(this.#lock);
    if (this.#wanted) controls.attach(this.#proxy);
    this.#stage.invalidate();
  }

  /** Arrows keep their length in pixels in a view of any height. */
  resize(height: number): void {
    this.#height = height;
    this.#controls?.setSize(this.#size());
  }

  #size(): number {
    return ARROWS / Math.max(1, this.#height);
  }

  /** The part under a pixel, which is highlighted; null beside all of them. */
  hover(x: number, y: number, width: number, height: number): Arrow | null {
    const controls = this.#controls;
    if (!controls?.object) return null;
    const before = controls.axis;
    // Typed as an event, but only a place in −1 … 1 is read from it.
    const place = { x: (2 * x) / width - 1, y: 1 - (2 * y) / height, button: 0 };
    controls.pointerHover(place as unknown as PointerEvent);
    // The middle, where all planes meet, belongs to the point itself.
    const part = PARTS[controls.axis ?? ""];
    if (!part) controls.axis = null;
    if (controls.axis !== before) this.#stage.invalidate();
    if (!part) return null;
    const columns = [new Vector3(), new Vector3(), new Vector3()] as const;
    this.#proxy.matrixWorld.extractBasis(...columns);
    const direction = columns[part[0] as 0 | 1 | 2].normalize();
    return { direction, plane: part[1], at: this.#proxy.position.clone() };
  }

  /** Display coordinates; along X, Y and Z without a frame. */
  attach(at: Vector3, frame: Frame | null): void {
    this.#proxy.position.copy(at);
    this.#proxy.quaternion.identity();
    if (frame) {
      const columns = [frame.along, frame.across, frame.normal].map((c) => new Vector3(...c));
      const [along = new Vector3(), across = new Vector3(), normal = new Vector3()] = columns;
      this.#proxy.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(along, across, normal));
    }
    this.#proxy.updateMatrixWorld();
    this.#wanted = true;
    if (this.#controls && !this.#controls.object) this.#controls.attach(this.#proxy);
    void this.#fetch();
    this.#stage.invalidate();
  }

  /** Shows only the arrows that a lock leaves. */
  show(lock: Lock | null): void {
    this.#lock = lock;
    if (!this.#controls) return;
    const axis = lock?.axis === "normal" ? "z" : lock?.axis;
    const shown = (name: string): boolean => !lock || (name === axis) !== lock.plane;
    this.#controls.showX = shown("x");
    this.#controls.showY = shown("y");
    this.#controls.showZ = shown("z");
  }

  detach(): void {
    this.#wanted = false;
    this.#controls?.detach();
    this.#stage.invalidate();
  }

  dispose(): void {
    this.#asked = false;
    this.#controls?.detach();
    this.#controls?.getHelper().dispose();
  }
}

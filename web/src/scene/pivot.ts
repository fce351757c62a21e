// SPDX-License-Identifier: MIT
// Turns of the camera about a point that it does not look at: the point keeps its place on screen.
import { type PerspectiveCamera, Quaternion, Vector3 } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";

/** Radians: less is the rounding of a camera that pans or zooms. */
const TURNED = 1e-5;

export class Pivot {
  readonly #camera: PerspectiveCamera;
  readonly #orbit: OrbitControls;
  #point: Vector3 | null = null;
  readonly #position = new Vector3();
  readonly #turn = new Quaternion();

  constructor(camera: PerspectiveCamera, orbit: OrbitControls) {
    this.#camera = camera;
    this.#orbit = orbit;
    orbit.addEventListener("change", () => this.#keep());
    orbit.addEventListener("end", () => this.set(null));
  }

  /** What the camera turns about until the controls are let go; null for what it looks at. */
  set(point: Vector3 | null): void {
    this.#point = point;
    this.#remember();
  }

  #remember(): void {
    this.#position.copy(this.#camera.position);
    this.#turn.copy(this.#camera.quaternion);
  }

  /** The controls have turned the camera about its target: moves both back to see the point as before. */
  #keep(): void {
    const { position, quaternion } = this.#camera;
    if (this.#point && quaternion.angleTo(this.#turn) > TURNED) {
      const seen = this.#point.clone().sub(this.#position);
      seen.applyQuaternion(this.#turn.clone().invert()).applyQuaternion(quaternion);
      const shift = this.#point.clone().sub(position).sub(seen);
      position.add(shift);
      this.#orbit.target.add(shift);
    }
    this.#remember();
  }
}

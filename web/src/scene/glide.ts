// SPDX-License-Identifier: MIT
// A short, eased way from one standpoint to another; a jump where motion is not wanted.
import { type Camera, Quaternion } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Standpoint } from "./framing.ts";

const MILLISECONDS = 160;

const still = window.matchMedia("(prefers-reduced-motion: reduce)");

export class Glide {
  readonly #camera: Camera;
  readonly #orbit: OrbitControls;
  #frame = 0;

  constructor(camera: Camera, orbit: OrbitControls) {
    this.#camera = camera;
    this.#orbit = orbit;
    orbit.addEventListener("start", () => this.stop());
  }

  jump({ position, target }: Standpoint): void {
    this.stop();
    this.#orbit.target.copy(target);
    this.#camera.position.copy(position);
    this.#orbit.update();
  }

  to(end: Standpoint): void {
    if (still.matches) {
      this.jump(end);
      return;
    }
    this.stop();
    const from = this.#orbit.target.clone();
    const arm = this.#camera.position.clone().sub(from);
    const endArm = end.position.clone().sub(end.target);
    const turn = new Quaternion().setFromUnitVectors(
      arm.clone().normalize(),
      endArm.clone().normalize(),
    );
    const begin = performance.now();
    const step = (now: number): void => {
      const share = Math.min(1, (now - begin) / MILLISECONDS);
      const eased = 1 - (1 - share) ** 3;
      const target = from.clone().lerp(end.target, eased);
      const length = arm.length() + (endArm.length() - arm.length()) * eased;
      const part = new Quaternion().slerp(turn, eased);
      const at = arm.clone().applyQuaternion(part).setLength(length).add(target);
      if (share === 1) this.jump(end);
      else {
        this.#orbit.target.copy(target);
        this.#camera.position.copy(at);
        this.#orbit.update();
        this.#frame = requestAnimationFrame(step);
      }
    };
    this.#frame = requestAnimationFrame(step);
  }

  stop(): void {
    cancelAnimationFrame(this.#frame);
  }
}

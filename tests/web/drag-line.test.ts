// SPDX-License-Identifier: MIT
// A drag along a line follows the pointer on screen: each pixel goes further, and the point stays beside it.
import { PerspectiveCamera, Raycaster, Vector2, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { dragged, type Held } from "../../web/src/scene/constraint.ts";
import { randomFrom } from "./support/mutations.ts";

const SIZE = { width: 1100, height: 800 };

/** Pixels. */
const screenPlace = (camera: PerspectiveCamera, place: Vector3): Vector2 => {
  const { x, y } = place.clone().project(camera);
  return new Vector2((0.5 + 0.5 * x) * SIZE.width, (0.5 - 0.5 * y) * SIZE.height);
};

function rayThrough(camera: PerspectiveCamera, { x, y }: Vector2) {
  const caster = new Raycaster();
  const [right, up] = [(2 * x) / SIZE.width - 1, 1 - (2 * y) / SIZE.height];
  caster.setFromCamera(new Vector2(right, up), camera);
  return caster.ray.clone();
}

/** A camera that looks at a model of ten units from somewhere above or beside it. */
function cameraFrom(random: () => number, fov: number): PerspectiveCamera {
  const camera = new PerspectiveCamera(fov, SIZE.width / SIZE.height, 0.1, 4000);
  const [turn, rise] = [2 * Math.PI * random(), 1.5 * random()];
  const far = 12 / Math.tan((fov * Math.PI) / 360);
  const target = new Vector3(random() - 0.5, random() - 0.5, 2 * random());
  camera.up.set(0, 0, 1);
  camera.position.set(
    Math.cos(turn) * Math.cos(rise),
    Math.sin(turn) * Math.cos(rise),
    Math.sin(rise),
  );
  camera.position.multiplyScalar(far).add(target);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera;
}

const unit = (random: () => number): Vector3 =>
  new Vector3(random() - 0.5, random() - 0.5, random() - 0.5).normalize();

describe.each([28, 60, 0.5])("a drag along a line, seen by a lens of %d degrees", (fov) => {
  it("goes further with every pixel and stays beside the pointer, 1,200 points", () => {
    const random = randomFrom(7 + fov);
    let steps = 0;
    let refused = 0;
    for (let k = 0; k < 1200; ++k) {
      const camera = cameraFrom(random, fov);
      const view = camera.getWorldDirection(new Vector3());
      const start = new Vector3(10 * random() - 5, 10 * random() - 5, 3 * random());
      const held: Held = { direction: k % 2 ? new Vector3(0, 0, 1) : unit(random), plane: false };
      const at = screenPlace(camera, start);
      // Taken hold of a few pixels beside it.
      const press = at.clone().add(new Vector2(12 * random() - 6, 12 * random() - 6));
      const drawn = screenPlace(camera, start.clone().addScaledVector(held.direction, 1e-3))
        .sub(at)
        .normalize();
      let last = Number.NEGATIVE_INFINITY;
      for (let pixels = -300; pixels <= 300; pixels += 15) {
        const sideways = 80 * random() - 40;
        const to = press
          .clone()
          .addScaledVector(drawn, pixels)
          .add(new Vector2(-drawn.y, drawn.x).multiplyScalar(sideways));
        const way = dragged(rayThrough(camera, press), rayThrough(camera, to), start, held, view);
        if (!way) {
          refused += 1;
          continue;
        }
        const length = way.dot(held.direction);
        expect(length).toBeGreaterThan(last);
        last = length;
        const shown = screenPlace(camera, start.clone().add(way)).sub(at).dot(drawn);
        expect(Math.abs(shown - pixels)).toBeLessThan(0.01 + 1e-4 * Math.abs(pixels));
        steps += 1;
      }
    }
    expect(steps).toBeGreaterThan(10 * refused);
  });
});

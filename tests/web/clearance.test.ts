// SPDX-License-Identifier: MIT
import { PerspectiveCamera, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import { clearStandpoint, type Subject } from "../../web/src/scene/clearance.ts";
import { type Sight, type Standpoint, sightOf } from "../../web/src/scene/framing.ts";
import { project } from "../../web/src/scene/picking.ts";

const [WIDTH, HEIGHT, TOP] = [800, 600, 52];

const camera = new PerspectiveCamera(28, WIDTH / HEIGHT, 0.1, 400);
camera.up.set(0, 0, 1);
camera.setViewOffset(WIDTH, HEIGHT, 0, -TOP / 2, WIDTH, HEIGHT);

/** A plate of 10 by `deep`, seen from above. */
function plate(deep: number): Subject {
  const points = [-5, -deep / 2, 0, 5, -deep / 2, 0, 5, deep / 2, 0, -5, deep / 2, 0];
  return {
    points: Float32Array.from(points),
    edges: Int32Array.from([0, 1, 1, 2, 2, 3, 3, 0]),
  };
}

const above: Sight = sightOf(camera, new Vector3(0, -0.001, 1).normalize());

/** Pixels of the plate's corners: left, top, right, bottom. */
function sidesFrom({ position, target }: Standpoint, { points }: Subject): number[] {
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  const places = [0, 1, 2, 3].map((v) =>
    project(points, v, { camera, width: WIDTH, height: HEIGHT }),
  );
  const xs = places.map((at) => at?.x ?? Number.NaN);
  const ys = places.map((at) => at?.y ?? Number.NaN);
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

const box = (left: number, top: number, right: number) => ({ left, top, right, bottom: 584 });

describe("the nearest clear standpoint", () => {
  it("is in the middle of what the tools leave free where nothing lies over the view", () => {
    const subject = plate(2);
    const [left = 0, top = 0, right = 0, bottom = 0] = sidesFrom(
      clearStandpoint(subject, above, TOP, []),
      subject,
    );
    expect(left).toBeCloseTo(WIDTH - right, 0);
    expect(top - TOP).toBeCloseTo(HEIGHT - bottom, 0);
    expect(right - left).toBeCloseTo(0.86 * WIDTH, 0);
  });

  it("does not care for a box that is beside the subject anyhow", () => {
    const subject = plate(2);
    const plain = clearStandpoint(subject, above, TOP, []);
    expect(clearStandpoint(subject, above, TOP, [box(16, 500, 280)])).toEqual(plain);
  });

  it("moves a wide subject up at the same size, no further than it takes", () => {
    const subject = plate(5);
    const plain = clearStandpoint(subject, above, TOP, []);
    expect(sidesFrom(plain, subject)[3]).toBeGreaterThan(470);
    const moved = clearStandpoint(subject, above, TOP, [box(16, 470, 280)]);
    const [, top = 0, , bottom = 0] = sidesFrom(moved, subject);
    expect(bottom).toBeLessThanOrEqual(470 - 12);
    expect(bottom).toBeGreaterThan(470 - 12 - 4);
    expect(top).toBeGreaterThan(TOP);
    expect(moved.position.distanceTo(moved.target)).toBeCloseTo(
      plain.position.distanceTo(plain.target),
      5,
    );
  });

  it("moves a high subject aside, if that leaves it larger", () => {
    const subject = plate(10);
    const over = [box(16, 440, 280), box(520, 560, 784)];
    const [left = 0, , right = 0, bottom = 0] = sidesFrom(
      clearStandpoint(subject, above, TOP, over),
      subject,
    );
    expect(left).toBeGreaterThanOrEqual(280 + 12);
    expect(bottom).toBeLessThanOrEqual(560 - 12);
    expect(right - left).toBeGreaterThan(0.86 * (440 - TOP));
  });

  it("sees edges that pass under a box whose ends lie outside", () => {
    const cross: Subject = { ...plate(10), edges: Int32Array.from([0, 2]) };
    const over = [box(300, 200, 320)];
    const plain = clearStandpoint(cross, above, TOP, []);
    const moved = clearStandpoint(cross, above, TOP, over);
    expect(sidesFrom(moved, cross)).not.toEqual(sidesFrom(plain, cross));
  });
});

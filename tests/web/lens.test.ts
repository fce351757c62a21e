// SPDX-License-Identifier: MIT
// The long lens shows what the wide one does, without its perspective.
import { PerspectiveCamera, Vector3 } from "three";
import { expect, it } from "vitest";
import {
  changeLens,
  clip,
  parallelDirection,
  WIDE,
  withWideLens,
} from "../../web/src/scene/lens.ts";

const target = new Vector3(1, 2, 3);

function camera(away: number): PerspectiveCamera {
  const made = new PerspectiveCamera(WIDE, 1.5, 0.1, 400);
  made.up.set(0, 0, 1);
  made.position.set(1, 2 - away, 3);
  made.lookAt(target);
  made.updateMatrixWorld();
  return made;
}

const onScreen = (from: PerspectiveCamera, x: number, y: number, z: number): Vector3 => {
  clip(from, target);
  from.updateMatrixWorld();
  return new Vector3(x, y, z).project(from);
};

it.each([25, 3])("about the target everything keeps its size and depth, %d away", (away) => {
  const seen = camera(away);
  const beside = onScreen(seen, 1.5, 2, 3);
  const step = onScreen(seen, 1, 2.1, 3).z - onScreen(seen, 1, 2, 3).z;
  changeLens(seen, target, true);
  expect(onScreen(seen, 1.5, 2, 3).x).toBeCloseTo(beside.x, 9);
  // What is behind is no smaller, but still behind: about as much as before.
  expect(onScreen(seen, 1.5, 4, 3).x / beside.x).toBeGreaterThan(0.98);
  const stepNow = onScreen(seen, 1, 2.1, 3).z - onScreen(seen, 1, 2, 3).z;
  expect(stepNow / step).toBeGreaterThan(0.2);
  expect(stepNow / step).toBeLessThan(2);
  changeLens(seen, target, false);
  expect(seen.position.distanceTo(new Vector3(1, 2 - away, 3))).toBeLessThan(1e-9);
});

it("a model of 10 units is before the camera as near as a hundredth of it fills the view", () => {
  const seen = camera(0.2);
  changeLens(seen, target, true);
  expect(onScreen(seen, 1, 2 - 5, 3).z).toBeGreaterThan(-1);
  expect(onScreen(seen, 1, 2 + 5, 3).z).toBeLessThan(1);
});

it("what is kept is the standpoint in perspective, and its direction tells the view", () => {
  const seen = camera(25);
  changeLens(seen, target, true);
  const kept = withWideLens(seen, target);
  expect(kept.position.distanceTo(new Vector3(1, -23, 3))).toBeLessThan(1e-9);
  expect(parallelDirection(kept)?.toArray()).toEqual([0, -1, 0]);
  const turned = { position: new Vector3(1.1, -23, 3), target };
  expect(parallelDirection(turned)).toBeNull();
});

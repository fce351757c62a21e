// SPDX-License-Identifier: MIT
// What drags ask of points of the samples, along the line that each is held to, seen as the page opens them.
import { PerspectiveCamera, Raycaster, Vector2, Vector3 } from "three";
import { expect, it } from "vitest";
import { SAMPLES } from "../../web/src/design/samples.ts";
import { usualLine } from "../../web/src/scene/constraint.ts";
import { displayPlace } from "../../web/src/scene/display-place.ts";
import { DragSession, type HeldDrag } from "../../web/src/scene/drag-session.ts";
import { DIRECTIONS, sightOf, standpoint } from "../../web/src/scene/framing.ts";
import { WIDE } from "../../web/src/scene/lens.ts";
import { type Drag, frameAt } from "../../web/src/state/dragging.ts";
import { shownPoint } from "../../web/src/state/editing.ts";
import type { Page } from "../../web/src/state/page.ts";
import { randomFrom } from "./support/mutations.ts";
import { openedPage } from "./support/page-here.ts";

const SIZE = { width: 1100, height: 800 };
const POINTS = 200;
const HELD: HeldDrag = {
  lock: null,
  snap: null,
  free: false,
  through: false,
  pixel: 1,
  byFinger: false,
  typed: null,
};

const placeOf = (page: Page, vertex: number): Vector3 =>
  new Vector3(...displayPlace(page, shownPoint(page, vertex)));

/** That of the view of the whole model. */
function cameraOf(places: readonly Vector3[]): PerspectiveCamera {
  const { width, height } = SIZE;
  const camera = new PerspectiveCamera(WIDE, width / height, 0.1, 4000);
  camera.up.set(0, 0, 1);
  camera.setViewOffset(width, height, 0, 0, width, height);
  const points = Float32Array.from(places.flatMap((place) => place.toArray()));
  const sight = sightOf(camera, new Vector3(...DIRECTIONS.Perspective).normalize());
  const { position, target } = standpoint(points, sight, { left: 60, top: 60, bottom: 60 });
  camera.position.copy(position);
  camera.lookAt(target);
  camera.updateMatrixWorld();
  return camera;
}

/** Pixels. */
const onScreen = (camera: PerspectiveCamera, place: Vector3): Vector2 => {
  const { x, y } = place.clone().project(camera);
  return new Vector2((0.5 + 0.5 * x) * SIZE.width, (0.5 - 0.5 * y) * SIZE.height);
};

function rayThrough(camera: PerspectiveCamera, { x, y }: Vector2) {
  const caster = new Raycaster();
  caster.setFromCamera(new Vector2((2 * x) / SIZE.width - 1, 1 - (2 * y) / SIZE.height), camera);
  return caster.ray.clone();
}

/** A drag that keeps what it is asked for, in display units; null where it cannot tell. */
class Asked {
  byFinger = false;
  offset: Vector3 | null = null;
  readonly #scale: number;

  constructor(scale: number) {
    this.#scale = scale;
  }

  by(offset: readonly number[]): void {
    this.offset = new Vector3(...offset).multiplyScalar(this.#scale);
  }

  endOn(): void {
    this.offset = null;
  }

  goesAside(): void {}
}

interface Dragged {
  readonly page: Page;
  readonly camera: PerspectiveCamera;
  readonly vertex: number;
  readonly random: () => number;
}

/** Drags by up to 300 pixels either way; the positions that were followed and those that were refused. */
function drag({ page, camera, vertex, random }: Dragged): readonly [number, number] {
  const [frame, start] = [frameAt(page, vertex), placeOf(page, vertex)];
  if (!frame) throw new Error("no mesh");
  const line = usualLine(
    new Vector3(...frame.normal),
    start.clone().sub(camera.position).normalize(),
  );
  if (!line) return [0, 0];
  const at = onScreen(camera, start);
  const drawn = onScreen(camera, start.clone().addScaledVector(line.direction, 1e-3))
    .sub(at)
    .normalize();
  const jitter = (by: number): number => by * (2 * random() - 1);
  const press = at.clone().add(new Vector2(jitter(6), jitter(6)));
  const scale = page.mesh.value?.report.scale ?? 1;
  const asked = new Asked(scale);
  const session = new DragSession(asked as unknown as Drag, {
    start,
    base: start,
    press: rayThrough(camera, press),
    view: camera.getWorldDirection(new Vector3()),
    frame,
    scale,
    arrow: null,
  });
  let [last, followed, refused] = [Number.NEGATIVE_INFINITY, 0, 0];
  for (let pixels = -300; pixels <= 300; pixels += 10) {
    const aside = new Vector2(-drawn.y, drawn.x).multiplyScalar(jitter(40));
    const to = press.clone().addScaledVector(drawn, pixels).add(aside);
    session.move(HELD, rayThrough(camera, to));
    const { offset } = asked;
    if (!offset) refused += 1;
    if (!offset) continue;
    followed += 1;
    const length = offset.dot(line.direction);
    expect(offset.addScaledVector(line.direction, -length).length()).toBeLessThan(1e-5);
    expect(length).toBeGreaterThan(last);
    last = length;
    const place = start.clone().addScaledVector(line.direction, length);
    expect(
      onScreen(camera, place).distanceTo(at.clone().addScaledVector(drawn, pixels)),
    ).toBeLessThan(2);
  }
  return [followed, refused];
}

it.each(SAMPLES.map(({ name }) => name))(
  `${POINTS} points of %s go further with every pixel, within 2 pixels of the pointer on their line`,
  async (name) => {
    const page = await openedPage(name);
    const count = page.mesh.value?.report.vertices ?? 0;
    const places = Array.from({ length: count }, (_, v) => placeOf(page, v));
    const [camera, random] = [cameraOf(places), randomFrom(11)];
    let [lines, followed, refused] = [0, 0, 0];
    for (let k = 0; k < POINTS; ++k) {
      const vertex = Math.floor((k * count) / POINTS);
      const [there, nowhere] = drag({ page, camera, vertex, random });
      if (there + nowhere > 0) lines += 1;
      followed += there;
      refused += nowhere;
    }
    // The others point at the viewer, and go on the plane of the screen.
    expect(lines).toBeGreaterThan(0.75 * POINTS);
    expect([followed, refused]).toEqual([61 * lines, 0]);
  },
);

// SPDX-License-Identifier: MIT
// Keep-outs on screen, translucent: a box as a box, a level and a plane as a slab on the side where
// nothing may be.
import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  DoubleSide,
  Group,
  LineBasicMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshStandardMaterial,
  Vector3,
} from "three";
import type { Point } from "../../design/design.ts";
import type { KeepOut } from "../../design/keep-outs.ts";
import type { Drawn } from "../../scene/drawing-follower.ts";
import { placed } from "../../scene/placing.ts";
import type { Stage } from "../../scene/stage.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";
import type { Outcome } from "../../state/action-queue.ts";
import type { Page } from "../../state/page.ts";
import { KeepOutArrows } from "./keep-out-arrows.ts";

export interface Surroundings {
  readonly page: Page;
  readonly stage: Stage;
  readonly mesh: OpenedMesh;
  readonly colour: string;
}

export interface MoveInView {
  readonly place: number;
  /** @param by model units */
  readonly to: (page: Page, place: number, by: Point) => Outcome;
}

const OPACITY = 0.16;
/** The structure is seen through two sides of a slab. */
const SLAB_OPACITY = 0.06;
const INK = 0.8;
/** A slab is larger than the structure by this, and as thick as a share of its size. */
const LARGER = 1.15;
const THICK = 0.05;

/** A box in display coordinates: from its middle to three of its sides. */
interface Solid {
  readonly middle: Vector3;
  readonly halves: readonly [Vector3, Vector3, Vector3];
}

/** On the side of the plane that `normal` (of any length) points to. */
function slab(around: Surroundings, normal: Vector3, bound: number): Solid {
  const { centre, scale } = around.mesh.report;
  const whole = new Box3().setFromArray(around.mesh.display);
  const [middle, half] = [
    whole.getCenter(new Vector3()),
    whole.getSize(new Vector3()).multiplyScalar(0.5),
  ];
  const away = normal.clone().normalize();
  const offset = (bound / normal.length() - away.dot(new Vector3(...centre))) * scale;
  const size = Math.max(half.length(), 1e-6);
  const foot = middle.clone().addScaledVector(away, offset - away.dot(middle));
  const axis = Math.abs(away.z) > 0.9 ? new Vector3(1, 0, 0) : new Vector3(0, 0, 1);
  const up = axis.sub(away.clone().multiplyScalar(axis.dot(away))).normalize();
  const across = up.clone().cross(away);
  const reach = (way: Vector3): number =>
    LARGER * (Math.abs(way.x) * half.x + Math.abs(way.y) * half.y + Math.abs(way.z) * half.z) +
    THICK * size;
  return {
    middle: foot.addScaledVector(away, 0.5 * THICK * size),
    halves: [
      across.clone().multiplyScalar(reach(across)),
      up.clone().multiplyScalar(reach(up)),
      away.multiplyScalar(0.5 * THICK * size),
    ],
  };
}

function solidOf(around: Surroundings, { kind, numbers }: KeepOut): Solid | null {
  const [a = 0, b = 0, c = 0, d = 0] = numbers;
  if (kind === "self" || kind === "mesh") return null;
  if (kind === "below") return slab(around, new Vector3(0, 0, -1), -a);
  if (kind === "above") return slab(around, new Vector3(0, 0, 1), a);
  if (kind === "plane") return slab(around, new Vector3(a, b, c), d);
  const [low, high] = [0, 3].map((corner) =>
    new Vector3().fromArray(placed(Float64Array.from(numbers), around.mesh.report), corner),
  );
  const box = new Box3(low, high);
  const half = box.getSize(new Vector3()).multiplyScalar(0.5);
  return {
    middle: box.getCenter(new Vector3()),
    halves: [new Vector3(half.x, 0, 0), new Vector3(0, half.y, 0), new Vector3(0, 0, half.z)],
  };
}

/** Corners of a box by the signs of its halves: bit 0 for the first, 1 and 2 for the others. */
const SIDES = [0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5];
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7];

/** From −1 to 1 along each axis. */
const CORNERS = Float32Array.from({ length: 24 }, (_, k) =>
  (Math.floor(k / 3) >> (k % 3)) & 1 ? 1 : -1,
);

function geometryOf(index: readonly number[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(CORNERS, 3));
  geometry.setIndex([...index]);
  return geometry;
}

const TRIANGLES = Array.from({ length: 6 }, (_, side) =>
  [0, 1, 2, 0, 2, 3].map((corner) => SIDES[4 * side + corner] ?? 0),
).flat();

const skinOf = (color: string, opacity: number): MeshStandardMaterial =>
  new MeshStandardMaterial({
    color,
    transparent: true,
    opacity,
    depthWrite: false,
    flatShading: true,
    side: DoubleSide,
  });

/** The panels of a model as fans, and their edges; around its middle, at which it stands. */
function modelParts(around: Surroundings, { numbers, panels = [] }: KeepOut): BodyParts {
  const display = placed(Float64Array.from(numbers), around.mesh.report);
  const middle = new Box3().setFromArray(display).getCenter(new Vector3());
  const points = Float32Array.from(display, (x, k) => x - middle.getComponent(k % 3));
  const position = new BufferAttribute(points, 3);
  const [sides, edges] = [new BufferGeometry(), new BufferGeometry()];
  for (const part of [sides, edges]) part.setAttribute("position", position);
  sides.setIndex(
    panels.flatMap(([first = 0, ...rest]) =>
      rest.slice(1).flatMap((v, k) => [first, rest[k] ?? 0, v]),
    ),
  );
  edges.setIndex(panels.flatMap((panel) => panel.flatMap((v, k) => [v, panel.at(k - 1) ?? v])));
  return { sides, edges, at: new Matrix4().setPosition(middle), own: true };
}

interface BodyParts {
  readonly sides: BufferGeometry;
  readonly edges: BufferGeometry;
  readonly at: Matrix4;
  /** Whether nothing else is drawn with its geometry. */
  readonly own: boolean;
}

/** Adds them to the scene; dispose() takes them away. */
export function drawKeepOuts(
  around: Surroundings,
  all: readonly KeepOut[],
  move: MoveInView | null,
): Drawn {
  const [sides, edges] = [geometryOf(TRIANGLES), geometryOf(EDGES)];
  const [skin, film] = [skinOf(around.colour, OPACITY), skinOf(around.colour, SLAB_OPACITY)];
  const ink = new LineBasicMaterial({ color: around.colour, transparent: true, opacity: INK });
  const group = new Group();
  const owned: BufferGeometry[] = [sides, edges];
  const partsOf = (one: KeepOut): BodyParts | null => {
    if (one.kind === "mesh") return modelParts(around, one);
    const solid = solidOf(around, one);
    if (!solid) return null;
    const at = new Matrix4().makeBasis(...solid.halves).setPosition(solid.middle);
    return { sides, edges, at, own: false };
  };
  let arrows: KeepOutArrows | null = null;
  for (const [place, one] of all.entries()) {
    const parts = partsOf(one);
    if (!parts) continue;
    if (parts.own) owned.push(parts.sides, parts.edges);
    const level = one.kind === "below" || one.kind === "above";
    const body = new Group().add(
      new Mesh(parts.sides, level || one.kind === "plane" ? film : skin),
      new LineSegments(parts.edges, ink),
    );
    body.applyMatrix4(parts.at);
    group.add(body);
    if (move?.place !== place) continue;
    const { page, stage, mesh } = around;
    arrows = new KeepOutArrows(page, stage, body, level, (by) => {
      const [x, y, z] = by.divideScalar(mesh.report.scale).toArray();
      void move.to(page, place, [x, y, z]);
    });
  }
  around.stage.scene.add(group);
  return {
    dispose() {
      arrows?.dispose();
      group.removeFromParent();
      for (const part of [...owned, skin, film, ink]) part.dispose();
    },
  };
}

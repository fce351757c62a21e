// SPDX-License-Identifier: MIT
// One drag in the view: rays in, offsets in model units out, held to a lock and snapped.
import { type Ray, Vector3 } from "three";
import type { Point } from "../design/design.ts";
import type { Frame } from "../mesh/point-frame.ts";
import type { Outcome } from "../state/action-queue.ts";
import type { Drag } from "../state/dragging.ts";
import type { Lock } from "../state/page-state.ts";
import { type Arrow, aside, dragged, type Held, snapOffset, usualLine } from "./constraint.ts";

const WORLD = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };

export interface DragStart {
  /** The point that leads, display coordinates. */
  readonly start: Vector3;
  /** Where it has its base position. */
  readonly base: Vector3;
  readonly press: Ray;
  /** The camera's direction. */
  readonly view: Vector3;
  readonly frame: Frame;
  /** Display units per model unit. */
  readonly scale: number;
  /** The arrow or plane that was taken hold of; null for the point itself. */
  readonly arrow: Arrow | null;
}

export interface Snap {
  /** Model units. */
  readonly step: number;
  /** Display units: nearer than this to the base position means there. */
  readonly reach: number;
}

/** What holds a drag, and what does not. */
export interface HeldDrag {
  readonly lock: Lock | null;
  readonly snap: Snap | null;
  /** Of the usual line. */
  readonly free: boolean;
  /** The limit on folds. */
  readonly through: boolean;
  /** What a pixel spans at depth 1. */
  readonly pixel: number;
  /** Beside which no key is held. */
  readonly byFinger: boolean;
  /** How far, model units, whatever the pointer says; null: it says so. */
  readonly typed: number | null;
}

/** The way that the pointer went, to the last bit along the line that it was held to. */
function ofLength(length: number, held: Held | null, way: Vector3 | null): Point {
  const line = held && !held.plane ? held.direction.clone() : null;
  const direction = line?.multiplyScalar(way && way.dot(line) < 0 ? -1 : 1) ?? way?.normalize();
  const { x, y, z } = direction ?? { x: 0, y: 0, z: 0 };
  return [length * x, length * y, length * z];
}

/** Pixels aside of its line from which on somebody may think that the point is stuck. */
const ASIDE = 40;

export class DragSession {
  readonly #drag: Drag;
  readonly #at: DragStart;
  readonly #local: readonly Vector3[];
  #ray: Ray;

  constructor(drag: Drag, at: DragStart) {
    this.#drag = drag;
    this.#at = at;
    this.#ray = at.press;
    const { along, across, normal } = at.frame;
    this.#local = [along, across, normal].map((vector) => new Vector3(...vector));
  }

  /** The pointer moved, or (without a ray) the lock or the snapping changed. */
  move(how: HeldDrag, ray: Ray = this.#ray): void {
    const { lock, snap, free, through, typed, pixel } = how;
    this.#ray = ray;
    const { start, arrow, press, view } = this.#at;
    const sight = start.clone().sub(press.origin).normalize();
    const usual = free ? null : usualLine(this.#local[2] ?? WORLD.z, sight);
    const held = lock ? this.#heldBy(lock) : (arrow ?? usual);
    const offset = dragged(press, ray, arrow?.at ?? start, held, view);
    this.#drag.byFinger = how.byFinger && !free;
    // A length or a step is asked for by name: no fold takes it back.
    if (typed !== null) this.#drag.by(ofLength(typed, held, offset), true);
    else if (!offset) this.#drag.endOn();
    else if (snap) this.#drag.by(this.#toModel(this.#snapped(offset, held, snap)), true);
    else this.#drag.by(this.#toModel(offset), through);
    const usualHolds = usual !== null && held === usual;
    this.#drag.goesAside(
      usualHolds && aside(press, ray, start, usual, view) > ASIDE * pixel
        ? usual.direction.z
        : null,
    );
  }

  end(): Outcome {
    return this.#drag.end();
  }

  abandon(): void {
    void this.#drag.abandon();
  }

  #heldBy({ axis, plane }: Lock): Held {
    const direction = axis === "normal" ? this.#local[2] : WORLD[axis];
    return { direction: direction ?? WORLD.z, plane };
  }

  #snapped(offset: Vector3, held: Held | null, { step, reach }: Snap): Vector3 {
    const { start, base, scale } = this.#at;
    const home = base.clone().sub(start);
    if (home.distanceTo(offset) < reach) return home;
    const size = step * scale;
    if (held && !held.plane) return snapOffset(offset, size, [held.direction]);
    const local = held !== null && this.#local[2] === held.direction;
    return snapOffset(offset, size, local ? this.#local : Object.values(WORLD));
  }

  /** What float32 display coordinates cannot tell from zero is zero: it keeps the target's bits. */
  #toModel(offset: Vector3): Point {
    const { scale } = this.#at;
    const part = (x: number): number => (Math.abs(x) < 1e-6 ? 0 : x / scale);
    return [part(offset.x), part(offset.y), part(offset.z)];
  }
}

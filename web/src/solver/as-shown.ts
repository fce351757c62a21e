// SPDX-License-Identifier: MIT
// What a session shows: where that has handles, and whether it is, as far as eyes can tell, what a drag showed.
import type { Session } from "@wasm/planish.mjs";
import type { HandleList } from "./protocol.ts";

/** Of the longest pull: a point may be this far from where it was shown. */
const ALIKE = 0.01;

type Place = readonly [number, number, number];

/** Points that moved, by vertex, model units. */
function placesIn(session: Session): ReadonlyMap<number, Place> {
  const p = session.movedPositions();
  const moved = Array.from(session.moved(), (v, k): [number, Place] => {
    return [v, [p[3 * k] ?? 0, p[3 * k + 1] ?? 0, p[3 * k + 2] ?? 0]];
  });
  return new Map(moved);
}

/** What a session shows, to be compared with what it shows later: where that is the same, gives true. */
export function shownIn(session: Session): (pull: number) => boolean {
  const before = placesIn(session);
  return (pull) => {
    const now = placesIn(session);
    let base: Float64Array | null = null;
    const resting = (v: number): Place => {
      base ??= session.basePositions();
      return [base[3 * v] ?? 0, base[3 * v + 1] ?? 0, base[3 * v + 2] ?? 0];
    };
    return [...new Set([...before.keys(), ...now.keys()])].every((v) => {
      const [a, b] = [before.get(v) ?? resting(v), now.get(v) ?? resting(v)];
      return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) <= ALIKE * pull;
    });
  };
}

/** `handles` where the shape that is shown has them; `base`: the same of the base. */
export function placesOf(session: Session, handles: HandleList, base: HandleList): HandleList {
  const [moved, positions] = [session.moved(), session.movedPositions()];
  const places = [...handles];
  for (let k = 0; k < places.length; k += 4) {
    const place = moved.indexOf(places[k] ?? -1);
    for (const axis of [0, 1, 2])
      places[k + 1 + axis] = (place < 0 ? base[k + 1 + axis] : positions[3 * place + axis]) ?? 0;
  }
  return places;
}

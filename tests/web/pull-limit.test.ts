// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import type { HandleList } from "../../web/src/solver/protocol.ts";
import {
  arrivalOf,
  arrives,
  keepsOwn,
  lags,
  ownBound,
  PullHold,
} from "../../web/src/solver/pull-limit.ts";

const FROM = [7, 0, 0, 1];
const LIMIT = 15;
const PATIENCE = 10_000;
const raised = (z: number): HandleList => [7, 0, 0, 1 + z];

/** Folds by ten degrees for every unit of height. */
const steady = ([, , , z = 0]: HandleList): number => 10 * (z - 1);

/** Edits that arrive as `holds` says: what was asked for and how, and what is shown. */
function frames(holds: (handles: HandleList, settled: boolean) => boolean) {
  let kept: HandleList = [];
  const made = {
    seen: [] as HandleList[],
    kinds: [] as boolean[],
    shown: [] as HandleList,
    edit: (handles: HandleList, settled: boolean): boolean => {
      made.seen.push(handles);
      made.kinds.push(settled);
      made.shown = handles;
      return holds(handles, settled);
    },
    keep: () => {
      kept = made.shown;
    },
    back: () => {
      made.shown = kept;
    },
  };
  return made;
}

const within = () => frames((handles) => steady(handles) <= LIMIT);

describe("the hold on a drag", () => {
  it("lets a pull within the limit through as it is, in one try", () => {
    const made = within();
    const asked = raised(1.5);
    expect(new PullHold().take(FROM, asked, made, PATIENCE)).toBe(asked);
    expect(made.seen).toEqual([asked]);
  });

  it("shows handles that hold after every frame, and comes within a fiftieth of the limit", () => {
    const hold = new PullHold();
    const made = within();
    let taken: HandleList = [];
    for (let z = 0.1; z < 4; z += 0.1) {
      const before = made.seen.length;
      taken = hold.take(FROM, raised(z), made, PATIENCE);
      expect(steady(taken)).toBeLessThanOrEqual(15);
      expect(made.shown).toEqual(taken);
      expect(made.seen.length - before).toBeLessThanOrEqual(7);
    }
    expect(taken[3]).toBeGreaterThan(2.5 - 0.02 * 4);
  });

  it("knows whether the last pull was held back, and from where", () => {
    const hold = new PullHold();
    hold.take(FROM, raised(1.5), within(), PATIENCE);
    expect(hold.heldBackFrom(raised(1.5))).toBe(false);
    hold.take(FROM, raised(4), within(), PATIENCE);
    expect(hold.heldBackFrom(raised(4))).toBe(true);
    expect(hold.heldBackFrom(raised(3))).toBe(false);
    hold.take(FROM, raised(1), within(), PATIENCE);
    expect(hold.heldBackFrom(raised(4))).toBe(false);
  });

  it("lets the other direction go, and the way back", () => {
    const hold = new PullHold();
    const made = within();
    hold.take(FROM, raised(4), made, PATIENCE);
    const down = raised(-3);
    expect(hold.take(FROM, down, made, PATIENCE)).toBe(down);
    const back = raised(1);
    expect(hold.take(FROM, back, made, PATIENCE)).toBe(back);
  });

  it("stays at what held where nothing holds further on any more", () => {
    const hold = new PullHold();
    const held = raised(1.4);
    hold.take(FROM, held, within(), PATIENCE);
    const made = frames(() => false);
    made.shown = held;
    made.keep();
    expect(hold.take(FROM, raised(1.9), made, PATIENCE)).toEqual(held);
    expect(made.shown).toEqual(held);
  });

  it("stays at what is shown where the longest that held does not come back", () => {
    const hold = new PullHold();
    hold.take(FROM, raised(9), within(), PATIENCE);
    const made = frames((handles) => steady(handles) <= 8);
    expect(hold.take(FROM, raised(0.5), made, PATIENCE)).toEqual(raised(0.5));
    const taken = hold.take(FROM, raised(9), made, PATIENCE);
    expect(taken).toEqual(raised(0.5));
    expect(made.shown).toEqual(taken);
  });

  it("asks for a settled edit where a frame did not hold, and for none while it stays", () => {
    const hold = new PullHold();
    const made = frames((handles, settled) => steady(handles) + (settled ? 0 : 20) <= LIMIT);
    const asked = raised(1.2);
    expect(hold.take(FROM, asked, made, PATIENCE)).toBe(asked);
    expect(made.kinds).toEqual([false, true]);
    hold.take(FROM, raised(9), made, PATIENCE);
    const tried = made.kinds.length;
    for (let k = 0; k < 6; ++k) hold.take(FROM, raised(9 + k), made, PATIENCE);
    expect(made.kinds.length - tried).toBeLessThan(12);
    const still = made.kinds.length;
    hold.take(FROM, raised(15), made, PATIENCE);
    expect(made.kinds.length).toBe(still);
  });

  it("makes one frame each once a search took too long, and says what held last", () => {
    const hold = new PullHold();
    const held = raised(1);
    hold.take(FROM, held, within(), 0);
    hold.take(FROM, raised(9), within(), 0);
    const made = within();
    expect(hold.take(FROM, raised(8), made, 1000)).toEqual(held);
    expect(hold.take(FROM, raised(1.2), made, 1000)).toEqual(raised(1.2));
    expect(made.seen).toEqual([raised(8), raised(1.2)]);
  });

  it("tries what held one way when the pull turns a little, and no more in that frame", () => {
    const hold = new PullHold();
    const taken = hold.take(FROM, raised(9), within(), PATIENCE);
    const made = within();
    for (const sideways of [4, 0, -4, 4]) {
      const turned = hold.take(FROM, [7, sideways, 0, 10], made, PATIENCE);
      const length = Math.hypot(turned[1] ?? 0, (turned[3] ?? 0) - 1);
      expect(length).toBeCloseTo((taken[3] ?? 0) - 1, 9);
    }
    expect(made.kinds).toEqual([false, false, false, false]);
  });
});

describe("an edit under a limit", () => {
  const limit = { degrees: 10, short: 0, from: FROM, base: FROM };
  const to = raised(2);
  const edit = { ...NO_REPORT, movedVertices: 9, maxDisplacement: 2 };
  const bound = { ...edit, bounds: { fold: [3] } };

  it("arrives within a twentieth of the way, or as far as nothing but panels lets it", () => {
    expect(arrives(limit, to, { ...bound, handleError: 0.09 })).toBe(true);
    expect(arrives(limit, to, { ...bound, handleError: 0.11 })).toBe(false);
    expect(arrives(limit, to, { ...edit, bounds: { fold: [] }, handleError: 0.9 })).toBe(true);
  });

  it("may stay as short as the drag began", () => {
    expect(arrives({ ...limit, short: 0.3 }, to, { ...bound, handleError: 0.59 })).toBe(true);
    expect(arrives({ ...limit, short: 0.3 }, to, { ...bound, handleError: 0.61 })).toBe(false);
  });

  it("lags where nothing but time keeps its handles from arriving", () => {
    const late = { ...edit, status: "iteration_limit", handleError: 0.5 };
    expect(lags(limit, to, late)).toBe(true);
    expect(lags(limit, to, { ...late, bounds: { fold: [3] } })).toBe(false);
    expect(lags(limit, to, { ...late, status: "converged" })).toBe(false);
    expect(lags(limit, to, { ...late, handleError: 0.05 })).toBe(false);
  });

  it("that found no way to move does not arrive", () => {
    const stuck = { ...edit, status: "iteration_limit", movedVertices: 0, sharpestFold: null };
    expect(arrives(limit, to, stuck)).toBe(false);
    expect(arrives(limit, to, { ...edit, status: "infeasible_handles" })).toBe(false);
  });

  it("stops short by shares of its pull", () => {
    const got = arrivalOf(limit, to, { ...bound, handleError: 0.5 }, 4);
    expect(got.short).toBe(0.125);
    expect(got.over).toBeCloseTo(0.1, 12);
    expect(arrivalOf(limit, to, { ...edit, handleError: 0.5 }, 4).over).toBeLessThanOrEqual(0);
    const refused = { ...edit, status: "infeasible_handles", handleError: 0.01 };
    expect(arrivalOf(limit, to, refused, 4).over).toBeGreaterThan(0);
  });

  it("keeps the drag's own limit where no fold sharpens by more", () => {
    const fold = (after: number) => ({ ...edit, sharpestFold: { before: 5, after } });
    expect(keepsOwn(limit, fold(15))).toBe(true);
    expect(keepsOwn(limit, fold(15.1))).toBe(false);
    expect(ownBound(limit)).toBe("fold=+10");
    expect(ownBound({ ...limit, degrees: Number.POSITIVE_INFINITY })).toBeNull();
  });
});

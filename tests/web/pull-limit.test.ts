// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { NO_REPORT } from "../../web/src/design/design.ts";
import type { HandleList } from "../../web/src/solver/protocol.ts";
import { isWithin, PullHold } from "../../web/src/solver/pull-limit.ts";

const FROM = [7, 0, 0, 1];
const LIMIT = 15;
const raised = (z: number): HandleList => [7, 0, 0, 1 + z];

/** Folds by ten degrees for every unit of height. */
const steady = ([, , , z = 0]: HandleList): number => 10 * (z - 1);

const within = (handles: HandleList): boolean => steady(handles) <= LIMIT;

function tries(attempt: (handles: HandleList) => boolean) {
  const seen: HandleList[] = [];
  return {
    seen,
    attempt: (handles: HandleList): boolean => {
      seen.push(handles);
      return attempt(handles);
    },
  };
}

describe("the hold on a drag", () => {
  it("lets a pull within the limit through as it is, in one try", () => {
    const { seen, attempt } = tries(within);
    const asked = raised(1.5);
    expect(new PullHold().take(FROM, asked, attempt)).toBe(asked);
    expect(seen).toEqual([asked]);
  });

  it("ends every frame at handles that hold, and comes within a fiftieth of the limit", () => {
    const hold = new PullHold();
    let taken: HandleList = [];
    for (let z = 0.1; z < 4; z += 0.1) {
      const { seen, attempt } = tries(within);
      taken = hold.take(FROM, raised(z), attempt);
      expect(steady(taken)).toBeLessThanOrEqual(15);
      if (seen.length > 0) expect(seen.at(-1)).toEqual(taken);
      expect(seen.length).toBeLessThanOrEqual(7);
    }
    expect(taken[3]).toBeGreaterThan(2.5 - 0.02 * 4);
  });

  it("lets the other direction go, and the way back", () => {
    const hold = new PullHold();
    hold.take(FROM, raised(4), within);
    const down = raised(-3);
    expect(hold.take(FROM, down, within)).toBe(down);
    const back = raised(1);
    expect(hold.take(FROM, back, within)).toBe(back);
  });

  it("goes back further where what held before does not any more", () => {
    const hold = new PullHold();
    hold.take(FROM, raised(1.4), within);
    const taken = hold.take(FROM, raised(1.45), (handles) => steady(handles) + 3 <= LIMIT);
    expect(steady(taken) + 3).toBeLessThanOrEqual(15);
    expect(taken[3]).toBeGreaterThan(1.8);
  });

  it("asks for a settled edit where a frame folded, and for none while it stays", () => {
    const hold = new PullHold();
    const kinds: boolean[] = [];
    const lagging = (handles: HandleList, settled: boolean): boolean => {
      kinds.push(settled);
      return steady(handles) + (settled ? 0 : 20) <= LIMIT;
    };
    const asked = raised(1.2);
    expect(hold.take(FROM, asked, lagging)).toBe(asked);
    expect(kinds).toEqual([false, true]);
    hold.take(FROM, raised(9), lagging);
    const tried = kinds.length;
    for (let k = 0; k < 6; ++k) hold.take(FROM, raised(9 + k), lagging);
    expect(kinds.length - tried).toBeLessThan(12);
    const still = kinds.length;
    hold.take(FROM, raised(15), lagging);
    expect(kinds.length).toBe(still);
  });

  it("lets frames go on that would wait too long, but not the end of the drag", () => {
    const hold = new PullHold();
    const asked = raised(9);
    expect(hold.take(FROM, asked, within, 0)).toBe(asked);
    const { seen, attempt } = tries(within);
    const next = raised(8);
    expect(hold.take(FROM, next, attempt, 1000)).toBe(next);
    expect(seen).toEqual([next]);
    expect(steady(new PullHold().take(FROM, next, within))).toBeLessThanOrEqual(15);
  });

  it("tries what held one way when the pull turns a little, and no more in that frame", () => {
    const hold = new PullHold();
    const taken = hold.take(FROM, raised(9), within);
    const kinds: boolean[] = [];
    for (const sideways of [4, 0, -4, 4]) {
      const turned = hold.take(FROM, [7, sideways, 0, 10], (handles, settled) => {
        kinds.push(settled);
        return within(handles);
      });
      const length = Math.hypot(turned[1] ?? 0, (turned[3] ?? 0) - 1);
      expect(length).toBeCloseTo((taken[3] ?? 0) - 1, 9);
    }
    expect(kinds).toEqual([false, false, false, false]);
  });
});

describe("an edit", () => {
  const limit = { degrees: 10, short: 0.15, from: FROM };
  const fold = { before: 5, after: 15 };
  const edit = { ...NO_REPORT, movedVertices: 9, sharpestFold: fold, maxDisplacement: 2 };

  it("is within the limit up to its degrees and as far as its handles follow", () => {
    expect(isWithin(limit, edit)).toBe(true);
    expect(isWithin(limit, { ...edit, sharpestFold: { before: 5, after: 15.1 } })).toBe(false);
    expect(isWithin(limit, { ...edit, handleError: 0.29 })).toBe(true);
    expect(isWithin(limit, { ...edit, handleError: 0.31 })).toBe(false);
    expect(
      isWithin({ ...limit, short: Number.POSITIVE_INFINITY }, { ...edit, handleError: 9 }),
    ).toBe(true);
  });

  it("that found no way to move is not", () => {
    const stuck = { ...edit, status: "iteration_limit", movedVertices: 0, sharpestFold: null };
    expect(isWithin(limit, stuck)).toBe(false);
  });
});

// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { FoldHold, type HandleList } from "../../web/src/solver/fold-limit.ts";

const LIMIT = { degrees: 15, from: [7, 0, 0, 1] };
const raised = (z: number): HandleList => [7, 0, 0, 1 + z];

/** Folds by ten degrees for every unit of height. */
const steady = ([, , , z = 0]: HandleList): number => 10 * (z - 1);

function tries(attempt: (handles: HandleList) => number) {
  const seen: HandleList[] = [];
  return {
    seen,
    attempt: (handles: HandleList): number => {
      seen.push(handles);
      return attempt(handles);
    },
  };
}

describe("the hold on a drag", () => {
  it("lets a pull within the limit through as it is, in one try", () => {
    const { seen, attempt } = tries(steady);
    const asked = raised(1.5);
    expect(new FoldHold().take(LIMIT, asked, attempt)).toBe(asked);
    expect(seen).toEqual([asked]);
  });

  it("ends every frame at handles that hold, and comes within a fiftieth of the limit", () => {
    const hold = new FoldHold();
    let taken: HandleList = [];
    for (let z = 0.1; z < 4; z += 0.1) {
      const { seen, attempt } = tries(steady);
      taken = hold.take(LIMIT, raised(z), attempt);
      expect(steady(taken)).toBeLessThanOrEqual(15);
      if (seen.length > 0) expect(seen.at(-1)).toEqual(taken);
      expect(seen.length).toBeLessThanOrEqual(7);
    }
    expect(taken[3]).toBeGreaterThan(2.5 - 0.02 * 4);
  });

  it("lets the other direction go, and the way back", () => {
    const hold = new FoldHold();
    hold.take(LIMIT, raised(4), steady);
    const down = raised(-3);
    expect(hold.take(LIMIT, down, steady)).toBe(down);
    const back = raised(1);
    expect(hold.take(LIMIT, back, steady)).toBe(back);
  });

  it("goes back further where what held before does not any more", () => {
    const hold = new FoldHold();
    hold.take(LIMIT, raised(1.4), steady);
    const taken = hold.take(LIMIT, raised(1.45), (handles) => steady(handles) + 3);
    expect(steady(taken) + 3).toBeLessThanOrEqual(15);
    expect(taken[3]).toBeGreaterThan(1.8);
  });

  it("asks for a settled edit where a frame folded, and for none while it stays", () => {
    const hold = new FoldHold();
    const kinds: boolean[] = [];
    const lagging = (handles: HandleList, settled: boolean): number => {
      kinds.push(settled);
      return steady(handles) + (settled ? 0 : 20);
    };
    const asked = raised(1.2);
    expect(hold.take(LIMIT, asked, lagging)).toBe(asked);
    expect(kinds).toEqual([false, true]);
    hold.take(LIMIT, raised(9), lagging);
    const tried = kinds.length;
    for (let k = 0; k < 6; ++k) hold.take(LIMIT, raised(9 + k), lagging);
    expect(kinds.length - tried).toBeLessThan(12);
    const still = kinds.length;
    hold.take(LIMIT, raised(15), lagging);
    expect(kinds.length).toBe(still);
  });

  it("lets frames go on that would wait too long, but not the end of the drag", () => {
    const hold = new FoldHold();
    const asked = raised(9);
    expect(hold.take(LIMIT, asked, steady, 0)).toBe(asked);
    const { seen, attempt } = tries(steady);
    const next = raised(8);
    expect(hold.take(LIMIT, next, attempt, 1000)).toBe(next);
    expect(seen).toEqual([next]);
    expect(steady(new FoldHold().take(LIMIT, next, steady))).toBeLessThanOrEqual(15);
  });

  it("tries what held one way when the pull turns a little, and no more in that frame", () => {
    const hold = new FoldHold();
    const taken = hold.take(LIMIT, raised(9), steady);
    const kinds: boolean[] = [];
    for (const sideways of [4, 0, -4, 4]) {
      const turned = hold.take(LIMIT, [7, sideways, 0, 10], (handles, settled) => {
        kinds.push(settled);
        return steady(handles);
      });
      const length = Math.hypot(turned[1] ?? 0, (turned[3] ?? 0) - 1);
      expect(length).toBeCloseTo((taken[3] ?? 0) - 1, 9);
    }
    expect(kinds).toEqual([false, false, false, false]);
  });
});

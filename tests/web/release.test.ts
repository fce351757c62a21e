// SPDX-License-Identifier: MIT
// The end of a drag whose frames could not follow, as on a fine mesh that hardly curves.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { expect, it } from "vitest";
import { FIRST_SETTINGS, NO_REPORT } from "../../web/src/design/design.ts";
import { boundNames } from "../../web/src/solver/bounds.ts";
import { Edits } from "../../web/src/solver/edits.ts";
import type { EditMode, HandleList, ShapeReport } from "../../web/src/solver/protocol.ts";

const FROM = [7, 0, 0, 1];
const raised = (z: number): HandleList => [7, 0, 0, 1 + z];

interface Asked {
  readonly how: EditMode;
  readonly way: number;
}

interface Shown {
  edit(how: EditMode, handles: Float64Array): string;
  keepEdit(): void;
  showKept(): void;
  shapeReport(): ShapeReport;
}

/** What the core says of a drag: frames catch up, and one that does not arrive is taken back to the last that did. */
function core(session: Shown, from: HandleList) {
  let [taken, goesOn, isHeldBack] = [from, false, false];
  const pullStanding = (_: unknown, handles: HandleList) => {
    const report = session.shapeReport();
    const { status, handleError } = report;
    const isBound = boundNames(report).length > 0;
    const isNear = handleError <= 0.05 * ((handles[3] ?? 0) - (from[3] ?? 0));
    const lags = status === "iteration_limit" && !isBound && !isNear;
    return { isStuck: false, isBound, arrives: !isBound || isNear, lags };
  };
  const follow = (_: unknown, handles: Float64Array) => {
    session.edit("drag", handles);
    for (let k = 0; k < 6 && pullStanding(_, [...handles]).lags; ++k) session.edit("drag", handles);
  };
  const hold = (_: unknown, handles: Float64Array): HandleList | null => {
    goesOn = true;
    follow(_, handles);
    isHeldBack = !pullStanding(_, [...handles]).arrives;
    if (isHeldBack) session.showKept();
    else {
      session.keepEdit();
      taken = [...handles];
    }
    return isHeldBack ? taken : null;
  };
  const pull = (_: unknown, way: string, handles: Float64Array) => {
    const back = way === "hold" ? hold(_, handles) : null;
    if (way === "follow") follow(_, handles);
    if (way === "release") session.edit("release", handles);
    if (way === "furthest") session.edit("solve", handles);
    return { problem: "", suffices: false, taken: back && Float64Array.from(back) };
  };
  const lastPull = () => ({ goesOn, isHeldBack, taken });
  const ways = ["follow", "near", "hold", "release", "furthest"].map((way) => [way, way]);
  return {
    PullWay: Object.fromEntries(ways),
    pull,
    pullStanding,
    lastPull,
    forgetDrag: () => {},
  };
}

/** Edits of one handle on a mesh where it gets as high as `reached` says; `status` of a frame, and from which way
 * on panels are at a limit. */
function bench(reached: (asked: Asked) => number, status = "iteration_limit", free = 99) {
  const all: Asked[] = [];
  let last: Asked = { how: "drag", way: 0 };
  let kept = last;
  const height = (): number => reached(last);
  const session = {
    setOptions: () => "",
    setSupports: () => "",
    keepEdit: () => {
      kept = last;
    },
    goBack: () => {},
    showKept: () => {
      last = kept;
    },
    edit: (how: EditMode, handles: Float64Array) => {
      last = { how, way: (handles[3] ?? 0) - 1 };
      all.push(last);
      return "";
    },
    moved: () => Int32Array.of(6, 7),
    movedPositions: () => Float64Array.of(9, 9, 9, 0, 0, 1 + height()),
    shapeReport: () => ({
      ...NO_REPORT,
      movedVertices: 2,
      status: last.how === "drag" ? status : "converged",
      bounds: { fold: last.way > free ? [3] : [] },
      handleError: Math.abs(last.way - height()),
    }),
  };
  const module = {
    ...core(session, FROM),
    EditMode: { drag: "drag", release: "release", solve: "solve" },
  };
  const edits = new Edits(
    module as unknown as PlanishModule,
    session as unknown as Session,
    () => 0,
  );
  const limit = { degrees: 10, short: 0, from: FROM, base: FROM };
  const edit = (way: number, mode: EditMode) => {
    const targets = { handles: raised(way), pins: [] };
    const common = { settings: FIRST_SETTINGS, budget: 0.016, limit, reaches: [], sought: null };
    return edits.edit({ kind: "edit", job: 1, mode, targets, ...common });
  };
  return { edit, all };
}

it("ends where the frames left the handle, by one solve and without a search", () => {
  const { edit, all } = bench(({ way }) => 0.04 * way);
  for (let k = 1; k <= 10; ++k) expect(edit(k / 10, "drag").taken).toBeNull();
  all.length = 0;
  const { taken, found } = edit(1, "release");
  expect(taken?.[3]).toBeCloseTo(1.04, 12);
  expect(taken?.slice(0, 3)).toEqual(FROM.slice(0, 3));
  expect(found).toEqual(["fold=+10"]);
  expect(all.filter(({ how }) => how !== "drag")).toEqual([
    { how: "solve", way: (taken?.[3] ?? 0) - 1 },
  ]);
});

it("gets to the pointer where its frames only lacked time", () => {
  let made = 0;
  // Each frame gets a tenth further: those of the end catch up.
  const { edit, all } = bench(({ how, way }) =>
    how === "drag" ? Math.min(1, made / 10) * way : way,
  );
  made = 8;
  expect(edit(1, "drag").taken).toBeNull();
  made = 10;
  expect(edit(1, "release").taken).toBeNull();
  expect(all.at(-1)).toEqual({ how: "release", way: 1 });
});

it("comes as near to where it was held back as its frames did, and no search goes on from there", () => {
  // The solve of what was shown is at the limit, and short of it, by less than the frame was.
  const reached = ({ how, way }: Asked) => (how === "drag" ? 0.8 : 0.85) * way;
  const { edit, all } = bench(reached, "converged", 0.61);
  expect(edit(0.6, "drag").taken).toBeNull();
  const held = edit(1, "drag").taken;
  expect(held?.[3]).toBeLessThan(1.62);
  all.length = 0;
  expect(edit(1, "release").taken).toEqual(held);
  // Frames had settled to another shape: the second looks for a path that has it.
  expect(all.map(({ how }) => how)).toEqual(["solve", "release"]);
});

it("ends where a frame that was held back lagged, not at what that one was asked for", () => {
  const { edit, all } = bench(({ way }) => 0.3 * way, "iteration_limit", 0.61);
  expect(edit(0.6, "drag").taken).toBeNull();
  const held = edit(1, "drag").taken?.[3] ?? 0;
  expect(held).toBeLessThan(1.62);
  all.length = 0;
  expect(edit(1, "release").taken?.[3]).toBeCloseTo(1 + 0.3 * (held - 1), 12);
  expect(all.filter(({ how }) => how === "solve")).toHaveLength(1);
});

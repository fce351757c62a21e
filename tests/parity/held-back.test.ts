// SPDX-License-Identifier: MIT
// A drag far beyond what the limit on folds lets through, to and fro, by the page's own dispatcher.
import { expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import { Dispatcher } from "../../web/src/solver/dispatch.ts";
import type { Reply, Request } from "../../web/src/solver/protocol.ts";
import { loadPlanish } from "./support/planish.ts";

const SIZE = 24;
const VERTEX = 12 * SIZE + 12;
const LIMIT = 10;
const FRAMES = 90;

/** Mean edges from where the drag began. */
const pull = (k: number): readonly number[] => [
  1.2 * Math.sin(k / 7),
  0.8 * Math.cos(k / 5),
  k < 30 ? k / 12 : 2.5 * Math.sin(k / 9),
];

it.each(["vault", "dome"])("every frame on a %s holds the limit and moves", async (name) => {
  const replies: Reply[] = [];
  const dispatcher = new Dispatcher(await loadPlanish(), (reply) => replies.push(reply));
  const ask = async (request: Exclude<Request, { kind: "start" }>): Promise<Reply | undefined> => {
    replies.length = 0;
    await dispatcher.handle(request);
    return replies.find(({ kind }) => kind !== "progress");
  };
  const source = { kind: "sample", name, size: SIZE } as const;
  const opened = await ask({
    kind: "open",
    job: 1,
    source,
    planarise: null,
    symmetry: null,
    cuts: [],
  });
  if (opened?.kind !== "opened") throw new Error("not opened");
  const { positions, report } = opened.mesh;
  const from = [VERTEX, ...positions.slice(3 * VERTEX, 3 * VERTEX + 3)];
  let shown = 0;
  for (let k = 1; k <= FRAMES; ++k) {
    const target = pull(k).map((x, axis) => (from[axis + 1] ?? 0) + report.meanEdge * x);
    const frame = await ask({
      kind: "edit",
      job: 2,
      mode: "drag",
      targets: { handles: [VERTEX, ...target], pins: [] },
      settings: FIRST_SETTINGS,
      budget: 10,
      limit: { degrees: LIMIT, short: 0, from, base: from },
      reaches: [],
      sought: null,
    });
    if (frame?.kind !== "shown") throw new Error(`frame ${k} was refused`);
    const { sharpestFold, maxDisplacement } = frame.report;
    expect(sharpestFold).not.toBeNull();
    const grown = (sharpestFold?.after ?? 0) - (sharpestFold?.before ?? 0);
    expect(grown, `frame ${k}`).toBeLessThanOrEqual(LIMIT + 1e-9);
    shown += maxDisplacement / report.meanEdge / FRAMES;
  }
  expect(shown).toBeGreaterThan(1);
});

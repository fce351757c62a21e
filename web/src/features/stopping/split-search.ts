// SPDX-License-Identifier: MIT
// Panels split where handles stop short: looked for beside the solver that holds the design, which
// stays as it is until one of the findings is taken.

import { signal } from "@preact/signals";
import { type Design, type HandleRow, toTargets } from "../../design/design.ts";
import { facesAt } from "../../mesh/reach.ts";
import { counted } from "../../quantity/counted.ts";
import type { SplitStanding } from "../../solver/protocol.ts";
import { GivenUp, type News, SecondSolver } from "../../solver/second-solver.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { baseOf, openKnownQuestion } from "../../state/connection.ts";
import { commitEdit, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { lastRefusedPull, refusedPull } from "../../state/refused-pull.ts";
import { openBase, restorePresent } from "../../state/showing.ts";

/** Lines through panels at most. */
const MOST = 4;

/** What so many lines give. */
export interface Curve {
  readonly asked: Design;
  /** From none on, the best of each number of lines; only what comes nearer than fewer do. */
  readonly standings: readonly SplitStanding[];
}

type Stage =
  | { readonly kind: "running"; readonly steps: number; readonly curve: Curve }
  | { readonly kind: "refused"; readonly sentence: string }
  /** `end`: that the handles arrive, that no more lines help, or that somebody stopped it. */
  | {
      readonly kind: "found";
      readonly curve: Curve;
      readonly end: "arrived" | "short" | "stopped";
    };

/** Of the design that it is looked for. */
export type Search = Stage & { readonly of: Design };

/** With what is new: of one number of lines the latest is the best. */
const withStanding = ({ asked, standings }: Curve, standing: SplitStanding): Curve => ({
  asked,
  standings: [...standings.filter(({ lines }) => lines < standing.lines), standing],
});

/** What no line gives, by the design that stopped: there while the first edits are still being solved. Null where its
 * folds were not measured. */
function uncutStanding(
  page: Page,
  design: Design,
  asked: readonly HandleRow[],
): SplitStanding | null {
  const mesh = page.mesh.value;
  const fold = design.report.sharpestFold;
  if (!mesh || !fold) return null;
  const short = asked.map(({ vertex, target }) => {
    const at = shownPoint(page, vertex, design.shape);
    return Math.hypot(...target.map((x, axis) => x - (at[axis] ?? 0)));
  });
  return {
    lines: 0,
    cuts: [],
    handleError: Math.max(0, ...short),
    movedVertices: design.report.movedVertices,
    // Panels with a moved corner.
    remadePanels: new Set(Array.from(design.shape.moved).flatMap((v) => facesAt(mesh, v))).size,
    sharpestFold: fold.after,
  };
}

const searches = kept((page) => ({
  now: signal<Search | null>(null),
  solver: new SecondSolver(page.spawn),
}));

/** The one for the design that is there; null for none. */
export function searchNow(page: Page): Search | null {
  const search = searches(page).now.value;
  return search && search.of === page.history.value?.present ? search : null;
}

/** What is looked for: the targets that were asked for, within the limits of the design. */
function asked(page: Page, design: Design): Design {
  const settings = { ...design.settings, continuation: 0 };
  return { ...design, handles: refusedPull(page).value?.handles ?? design.handles, settings };
}

/** Whether lines can be looked for: the paper's engine knows none. */
export const canSplit = ({ settings }: Design): boolean => settings.engine === "newton";

/** Ends what runs; what it found stays. */
export function stopSearch(page: Page): void {
  const { now, solver } = searches(page);
  const search = now.peek();
  solver.end();
  if (search?.kind !== "running") return;
  const { of, curve } = search;
  const found = curve.standings.length > 1;
  now.value = found ? { of, kind: "found", curve, end: "stopped" } : null;
}

/** Gives up what runs; what was found is forgotten. */
export function endSearch(page: Page): void {
  searches(page).solver.end();
  searches(page).now.value = null;
}

export async function search(page: Page): Promise<void> {
  const [of, mesh] = [page.history.value?.present, page.mesh.value];
  if (!of || !mesh) return;
  const { now, solver } = searches(page);
  const wish = asked(page, of);
  const { settings } = wish;
  const targets = toTargets(wish.handles);
  const onNews = (news: News): void => {
    const search = now.peek();
    if (search?.of !== of || search.kind !== "running") return;
    now.value =
      news.kind === "progress"
        ? { ...search, steps: news.step }
        : { ...search, curve: withStanding(search.curve, news.standing) };
  };
  const uncut = uncutStanding(page, of, wish.handles);
  const curve = { asked: wish, standings: uncut ? [uncut] : [] };
  now.value = { of, kind: "running", steps: 0, curve };
  try {
    const finding = await solver.run(async (ask) => {
      await ask(openKnownQuestion(baseOf(of), mesh), "opened");
      const question = { kind: "splitEdit", targets, settings, most: MOST } as const;
      return (await ask(question, "split", onNews)).finding;
    });
    solver.end();
    const { curve: standings, reached } = finding;
    const end = reached ? "arrived" : "short";
    now.value = { of, kind: "found", curve: { asked: wish, standings }, end };
  } catch (error) {
    if (error instanceof GivenUp) return;
    const sentence = error instanceof Error ? error.message : String(error);
    now.value = { of, kind: "refused", sentence };
  }
}

/** The cuts become the design's, and the edit is solved on what they leave, as one step. */
export const takeSplits = (page: Page, { asked }: { asked: Design }, by: SplitStanding): Outcome =>
  enqueue(page, async () => {
    const { settings } = asked;
    const next = { ...asked, settings: { ...settings, cuts: [...settings.cuts, ...by.cuts] } };
    const based = await openBase(page, next);
    if (!based.ok) return restorePresent(page, based);
    const made = await commitEdit(page, { ...based.value, handles: asked.handles }, "solve");
    if (!made?.ok) return made;
    lastRefusedPull(page).value = null;
    if (by.cuts.length === 0) return made;
    const lines = counted(by.lines, "line");
    page.notice.value = `Split by ${lines} between corners; the edit was solved again on that mesh. Undo takes both back.`;
    return made;
  });

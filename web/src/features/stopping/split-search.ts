// SPDX-License-Identifier: MIT
// Panels split where handles stop short: looked for beside the solver that holds the design, which
// stays as it is until one of the findings is taken.

import { signal } from "@preact/signals";
import { type Design, toTargets } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import type { SplitFinding, SplitStanding } from "../../solver/protocol.ts";
import { type Ask, GivenUp, SecondSolver } from "../../solver/second-solver.ts";
import { commitEdit } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { openBase, takeBack } from "../../state/showing.ts";
import { inTurn, type Outcome } from "../../state/turns.ts";
import { beyond, wanted } from "../../state/wanted.ts";

/** Lines through panels at most. */
const MOST = 4;

type Stage =
  | { readonly kind: "running"; readonly steps: number }
  | { readonly kind: "refused"; readonly sentence: string }
  | { readonly kind: "found"; readonly asked: Design; readonly finding: SplitFinding };

/** Of the design that it is looked for. */
export type Search = Stage & { readonly of: Design };

const searches = kept((page) => ({
  now: signal<Search | null>(null),
  solver: new SecondSolver(page.spawn),
}));

/** The one for the design that is there; null for none. */
export function searchNow(page: Page): Search | null {
  const search = searches(page).now.value;
  return search && search.of === page.history.value?.present ? search : null;
}

/** What is looked for: the targets that were asked for, where folds sharpen by no more than they may. */
function asked(page: Page, design: Design): Design {
  const pull = beyond(page).value;
  const growth = pull?.growth ?? null;
  const more = growth === null ? [] : [`fold=+${growth}`];
  const limits = [...design.settings.limits, ...more];
  const settings = { ...design.settings, limits, continuation: 0 };
  return { ...design, handles: pull?.handles ?? design.handles, settings };
}

/** Whether lines can be looked for: they have no images, and the paper's engine knows none. */
export const canSplit = ({ settings }: Design): boolean =>
  settings.symmetry.length === 0 && settings.engine === "newton";

/** Opens the mesh of the design, which is flat already where its file is not. */
async function open(ask: Ask, { source, planarised, settings }: Design, flat: Float64Array) {
  const plain = { source, planarise: null, symmetry: null, cuts: [] } as const;
  const { mesh } = await ask({ kind: "open", ...plain }, "opened");
  // Cuts move no point, and add theirs behind all others.
  const found = flat.slice(0, mesh.positions.length);
  if (planarised) await ask({ kind: "planarise", how: planarised, found }, "opened");
  const { cuts } = settings;
  if (cuts.length > 0) await ask({ kind: "cut", cuts, tolerance: 0 }, "opened");
}

/** Gives up what runs; what was found is forgotten. */
export function endSearch(page: Page): void {
  searches(page).solver.end();
  searches(page).now.value = null;
}

export async function search(page: Page): Promise<void> {
  const [of, flat] = [page.history.value?.present, page.mesh.value?.positions];
  if (!of || !flat) return;
  const { now, solver } = searches(page);
  const wish = asked(page, of);
  const { settings } = wish;
  const targets = toTargets(wish.handles);
  const onStep = (steps: number): void => {
    if (now.peek()?.of === of) now.value = { of, kind: "running", steps };
  };
  now.value = { of, kind: "running", steps: 0 };
  try {
    const finding = await solver.run(async (ask) => {
      await open(ask, of, flat);
      const question = { kind: "splitEdit", targets, settings, most: MOST } as const;
      return (await ask(question, "split", onStep)).finding;
    });
    solver.end();
    now.value = { of, kind: "found", asked: wish, finding };
  } catch (error) {
    if (error instanceof GivenUp) return;
    const sentence = error instanceof Error ? error.message : String(error);
    now.value = { of, kind: "refused", sentence };
  }
}

/** The cuts become the design's, and the edit is solved on what they leave, as one step. */
export const takeSplits = (page: Page, { asked }: { asked: Design }, by: SplitStanding): Outcome =>
  inTurn(page, async () => {
    const { settings } = asked;
    const next = { ...asked, settings: { ...settings, cuts: [...settings.cuts, ...by.cuts] } };
    const based = await openBase(page, next);
    if (!based.ok) return takeBack(page, based);
    const made = await commitEdit(page, { ...based.value, handles: asked.handles }, "solve");
    if (!made?.ok) return made;
    wanted(page).value = null;
    if (by.cuts.length === 0) return made;
    const lines = counted(by.cuts.length, "line");
    page.notice.value = `Split by ${lines} between corners; the edit was solved again on that mesh. Undo takes both back.`;
    return made;
  });

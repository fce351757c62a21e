// SPDX-License-Identifier: MIT
// Puts a known design on the screen and into the solver without solving anything.

import { batch } from "@preact/signals";
import { type Design, NO_SHAPE, sourceName } from "../design/design.ts";
import type { History } from "../design/history.ts";
import { sameWay } from "../design/planarising.ts";
import { sameSymmetry } from "../design/symmetry.ts";
import { done, type Refusal, type Result } from "../result/result.ts";
import type { OpenedMesh, Source } from "../solver/protocol.ts";
import { displayOfShape } from "../solver/shape-display.ts";
import { dropQueued, enqueue, holdQueue } from "./action-queue.ts";
import {
  announceChanges,
  type Base,
  baseOf,
  cutQuestion,
  held,
  onDeath,
  openQuestion,
  restartSolver,
  restoreQuestion,
  run,
  tell,
} from "./connection.ts";
import { kept, type Page } from "./page.ts";
import { report, say } from "./telling.ts";

const sameSource = (a: Source, b: Source): boolean => {
  if (a === b) return true;
  if (a.kind === "sample") return b.kind === "sample" && a.name === b.name && a.size === b.size;
  if (b.kind === "sample" || a.format !== b.format) return false;
  return a.crc === b.crc && a.bytes.size === b.bytes.size;
};

/** Whether two bases are one but for what evening out takes. */
const sameUpToSymmetry = (a: Base, b: Base): boolean =>
  sameWay(a.planarised, b.planarised) &&
  sameSource(a.source, b.source) &&
  a.cuts.join() === b.cuts.join();

/** Whether two designs are edits of one mesh, up to what evening it out takes. */
export const sameMesh = (a: Design, b: Design): boolean => sameUpToSymmetry(baseOf(a), baseOf(b));

const sameBase = (a: Base, b: Base): boolean =>
  sameUpToSymmetry(a, b) && sameSymmetry(a.symmetry, b.symmetry);

interface Own {
  /** The base of the mesh on screen; null before the first. */
  shown: Base | null;
  /** The design that a new solver is being told after Cancel; it is on screen already. */
  retold: { readonly design: Design; readonly done: Promise<Result<unknown>> } | null;
  tries: number;
}

const own = kept((): Own => ({ shown: null, retold: null, tries: 0 }));

/** Takes over a mesh that the solver has opened; the points of the one before are let go. */
export function takeMesh(page: Page, design: Design, opened: OpenedMesh): void {
  own(page).shown = baseOf(design);
  batch(() => {
    if (page.draft.value?.source !== design.source) page.toleranceTaken.value = false;
    page.mesh.value = opened;
    page.displayMesh.value = opened;
    page.draft.value = design;
    page.figures.value = design.report;
    page.selection.value = [];
    page.selectedPanel.value = null;
    page.visited.value = null;
    page.lock.value = null;
    page.panelFigures.value = null;
    page.panelHealth.value = null;
    page.nodeCounts.value = null;
    page.panelTroubles.value = null;
    page.panelDamage.value = null;
    page.bending.value = null;
    page.panelFolds.value = null;
    page.freedom.value = null;
    page.hintVertex.value = null;
    page.importReport.value = false;
    page.refusedTolerance.value = null;
  });
}

/** Lets the solver have the mesh of `design`, and the screen too; the answer has no shape where that is
 * another mesh, and the symmetries that were found, where all were asked for. */
export async function openBase(page: Page, design: Design): Promise<Result<Design>> {
  const [{ base }, wanted] = [held(page), baseOf(design)];
  if (base && sameBase(base, wanted)) return done(design);
  const cutsAlone = base !== null && sameBase({ ...base, cuts: wanted.cuts }, wanted);
  const label = cutsAlone ? "cutting" : `opening ${sourceName(design.source)}`;
  const question = cutsAlone ? cutQuestion(wanted) : openQuestion(wanted);
  const answer = await run(page, label, question, "opened");
  if (!answer.ok) return answer;
  const { mesh } = answer.value;
  const symmetry = mesh.symmetry?.elements ?? [];
  const found = { ...design, settings: { ...design.settings, symmetry } };
  const { shown } = own(page);
  if (shown && sameBase(shown, baseOf(found))) {
    announceChanges(page, displayOf(page, found));
    return done(found);
  }
  // The shape is of another mesh, whose points may have had other numbers.
  const unedited = { ...found, shape: NO_SHAPE };
  takeMesh(page, unedited, mesh);
  return done(unedited);
}

export async function show(page: Page, design: Design): Promise<Result<unknown>> {
  // What was cancelled ends here, having asked for the design it began with.
  const { retold } = own(page);
  if (retold?.design === design) return retold.done;
  const opened = await openBase(page, design);
  if (!opened.ok) return opened;
  page.draft.value = design;
  page.refusedTolerance.value = null;
  const { variation } = design;
  const keep = variation !== null && variation.centre === held(page).centre;
  const restored = await run(page, "restoring", restoreQuestion(design, keep), "shown");
  if (restored.ok) page.figures.value = design.report;
  return restored;
}

/** Back to the last finished design, after whatever was tried; undefined where it is there. */
export async function showPresent(page: Page): Promise<Refusal | undefined> {
  const present = page.history.value?.present;
  const shown = present && (await show(page, present));
  return shown && !shown.ok ? shown : undefined;
}

/** Shows the design again after something was refused: what is to be said of both. */
export async function restorePresent(page: Page, refusal: Refusal): Promise<Refusal> {
  const back = await showPresent(page);
  return back?.reason ? back : refusal;
}

/**
 * Shows a known design as the next step of the history; undefined where that is done, which takes back
 * nothing that was said.
 */
export async function showStep(
  page: Page,
  design: Design,
  history: History<Design>,
): Promise<Refusal | undefined> {
  const shown = await show(page, design);
  if (!shown.ok) return restorePresent(page, shown);
  page.history.value = history;
  return undefined;
}

/** A solver that dies of the design itself must not be started for ever. */
const TRIES = 3;

/** Sees to it that a solver that dies is replaced, and the new one told what is on screen. */
export function recoverFromDeath(page: Page): void {
  const mine = own(page);
  onDeath(page, () => {
    mine.tries += 1;
    if (mine.tries > TRIES) {
      say(page, "The solver keeps stopping. Reload the page: the design is kept.");
      return;
    }
    dropQueued(page);
    void enqueue(page, async () => {
      const refusal = await showPresent(page);
      if (!refusal && page.history.value) mine.tries = 0;
      return refusal;
    });
  });
}

/**
 * Stops whatever runs and puts the last finished design back at once. The page knows it to the last
 * bit, so nobody waits for the new solver: it is told behind the scenes, and later actions wait.
 */
export function cancel(page: Page): void {
  const trial = page.planariseTrial.peek();
  if (trial.kind === "running") trial.giveUp();
  dropQueued(page);
  restartSolver(page);
  const design = page.history.value?.present;
  if (!design) return;
  page.draft.value = design;
  page.figures.value = design.report;
  const mine = own(page);
  if (!mine.shown || !sameBase(mine.shown, baseOf(design))) {
    void enqueue(page, () => showPresent(page));
    return;
  }
  announceChanges(page, displayOf(page, design));
  // Mesh and design are told at once: no frame of a drag gets in between.
  const told = tell(page, openQuestion(baseOf(design)), restoreQuestion(design, false));
  const retold = { design, done: told };
  mine.retold = retold;
  holdQueue(
    page,
    told.then((result) => {
      if (!result.ok) report(page, result);
      if (mine.retold === retold) mine.retold = null;
    }),
  );
}

/** Draws a design of the mesh that is open; the page and the solver keep their own. */
export const showOnly = (page: Page, design: Design): void =>
  announceChanges(page, displayOf(page, design));

/** The whole design in display coordinates, from what the page itself keeps. */
function displayOf(page: Page, design: Design): Float32Array {
  const opened = page.mesh.value;
  if (!opened) return new Float32Array(0);
  const points = displayOfShape(opened, design.shape);
  const all = new Float32Array((points.length / 3) * 4);
  for (let v = 0; v < points.length / 3; ++v) {
    all[4 * v] = v;
    all.set(points.subarray(3 * v, 3 * v + 3), 4 * v + 1);
  }
  return all;
}

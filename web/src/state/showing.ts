// SPDX-License-Identifier: MIT
// Puts a known design on the screen and into the solver without solving anything.
import { batch } from "@preact/signals";
import type { OpenedMesh, Source } from "../solver/protocol.ts";
import {
  announceChanges,
  type Base,
  held,
  onDeath,
  restartSolver,
  run,
  tell,
} from "./connection.ts";
import { type Design, sourceName, toTargets } from "./design.ts";
import { sameWay } from "./planarising.ts";
import {
  bending,
  displayMesh,
  draft,
  figures,
  freedom,
  hintVertex,
  history,
  importReport,
  lock,
  mesh,
  nodeCounts,
  panelDamage,
  panelFigures,
  panelFolds,
  panelHealth,
  panelTroubles,
  planariseTrial,
  problem,
  refusedTolerance,
  selectedPanel,
  selection,
  visited,
} from "./store.ts";
import { dropTurns, holdTurns, inTurn } from "./turns.ts";

const sameSource = (a: Source, b: Source): boolean => {
  if (a === b) return true;
  if (a.kind === "sample") return b.kind === "sample" && a.name === b.name && a.size === b.size;
  if (b.kind === "sample" || a.format !== b.format) return false;
  return a.crc === b.crc && a.bytes.size === b.bytes.size;
};

export const sameBase = (a: Base, b: Base): boolean =>
  sameWay(a.planarised, b.planarised) && sameSource(a.source, b.source);

/** The base of the mesh on screen; null before the first. */
let shown: Base | null = null;

/** Takes over a mesh that the solver has opened; the points of the one before are let go. */
export function takeMesh(design: Design, opened: OpenedMesh): void {
  const { source, planarised } = design;
  shown = { source, planarised };
  batch(() => {
    mesh.value = opened;
    displayMesh.value = opened;
    draft.value = design;
    figures.value = design.report;
    selection.value = [];
    selectedPanel.value = null;
    visited.value = null;
    lock.value = null;
    panelFigures.value = null;
    panelHealth.value = null;
    nodeCounts.value = null;
    panelTroubles.value = null;
    panelDamage.value = null;
    bending.value = null;
    panelFolds.value = null;
    freedom.value = null;
    hintVertex.value = null;
    importReport.value = false;
    refusedTolerance.value = null;
  });
}

const openQuestion = ({ source, planarised }: Design) =>
  ({ kind: "open", source, planarise: planarised }) as const;

const restoreQuestion = ({ handles, settings, shape }: Design, keep: boolean) =>
  ({ kind: "restore", targets: toTargets(handles), settings, shape, keep }) as const;

async function openBase(design: Design): Promise<boolean> {
  if (held.base && sameBase(held.base, design)) return true;
  const answer = await run(`opening ${sourceName(design.source)}`, openQuestion(design), "opened");
  if (!answer) return false;
  if (shown && sameBase(shown, design)) announceChanges(displayOf(design));
  else takeMesh(design, answer.mesh);
  return true;
}

/** The design that a new solver is being told after Cancel; it is on screen already. */
let retold: { readonly design: Design; readonly done: Promise<boolean> } | null = null;

/** False if it could not be done; then the problem has been said. */
export async function show(design: Design): Promise<boolean> {
  // What was cancelled ends here, having asked for the design it began with.
  if (retold?.design === design) return retold.done;
  const kept = problem.value;
  if (!(await openBase(design))) return false;
  draft.value = design;
  refusedTolerance.value = null;
  const { variation } = design;
  const keep = variation !== null && variation.centre === held.centre;
  if (!(await run("restoring", restoreQuestion(design, keep), "shown"))) return false;
  figures.value = design.report;
  problem.value = kept;
  return true;
}

/** Back to the last finished design, after whatever was tried. */
export async function showPresent(): Promise<void> {
  if (history.value) await show(history.value.present);
}

/** A solver that dies of the design itself must not be started for ever. */
const TRIES = 3;
let tries = 0;

onDeath(() => {
  tries += 1;
  if (tries > TRIES) {
    problem.value = "The solver keeps stopping. Reload the page: the design is kept.";
    return;
  }
  dropTurns();
  void inTurn(async () => {
    if (history.value && (await show(history.value.present))) tries = 0;
  });
});

/**
 * Stops whatever runs and puts the last finished design back at once. The page knows it to the last
 * bit, so nobody waits for the new solver: it is told behind the scenes, and later actions wait.
 */
export function cancel(): void {
  const trial = planariseTrial.peek();
  if (trial.kind === "running") trial.giveUp();
  dropTurns();
  restartSolver();
  const design = history.value?.present;
  if (!design) return;
  draft.value = design;
  figures.value = design.report;
  if (!shown || !sameBase(shown, design)) {
    void inTurn(showPresent);
    return;
  }
  announceChanges(displayOf(design));
  // Both at once: no frame of a drag gets in between.
  const done = tell(openQuestion(design), restoreQuestion(design, false));
  const mine = { design, done };
  retold = mine;
  holdTurns(
    done.then(() => {
      if (retold === mine) retold = null;
    }),
  );
}

/** Draws a design of the mesh that is open; the page and the solver keep their own. */
export const showOnly = (design: Design): void => announceChanges(displayOf(design));

/** The whole design in display coordinates, from what the page itself keeps. */
function displayOf(design: Design): Float32Array {
  const opened = mesh.value;
  if (!opened) return new Float32Array(0);
  const { centre, scale } = opened.report;
  const { display } = opened;
  const all = new Float32Array((display.length / 3) * 4);
  for (let v = 0; v < display.length / 3; ++v) {
    all[4 * v] = v;
    for (let axis = 0; axis < 3; ++axis) all[4 * v + 1 + axis] = display[3 * v + axis] ?? 0;
  }
  const { moved, positions } = design.shape;
  moved.forEach((v, k) => {
    const at = (axis: 0 | 1 | 2) => ((positions[3 * k + axis] ?? 0) - centre[axis]) * scale;
    all.set([v, at(0), at(1), at(2)], 4 * v);
  });
  return all;
}

// SPDX-License-Identifier: MIT
// How far each way on gets: tried one after the other beside the solver that holds the design, which
// stays as it is.

import { signal } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import type { PanelMeasures, ShapeReport } from "../../solver/protocol.ts";
import { GivenUp, SecondSolver } from "../../solver/second-solver.ts";
import { baseOf, openKnownQuestion } from "../../state/connection.ts";
import { damageWords, spoiltPanels } from "../../state/damage.ts";
import { editQuestion } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { type Asked, askedBy, type Stopped, stopIn, stopped } from "./going-on.ts";
import type { Gain, WayOn } from "./way-on.ts";

/** Of a mesh: on a larger one the tries would take minutes. */
const MOST_POINTS = 20_000;

/** Of one design's ways on, by their labels; those that were refused have none. */
export interface Gains {
  readonly of: Stopped;
  readonly known: ReadonlyMap<string, Gain>;
  readonly done: boolean;
}

const tries = kept((page) => ({
  now: signal<Gains | null>(null),
  solver: new SecondSolver(page.spawn),
}));

/** The gains of where the design that is there stops; null where none is tried. */
export function gainsNow(page: Page): Gains | null {
  const gains = tries(page).now.value;
  return gains && gains.of === stopped(page).value ? gains : null;
}

/** Gives up what runs; what was found is forgotten. */
export function endTries(page: Page): void {
  tries(page).solver.end();
  tries(page).now.value = null;
}

function gainOf(
  page: Page,
  { next, handles }: Asked,
  { shape, report }: Pick<Design, "shape"> & { readonly report: ShapeReport },
  measures: PanelMeasures | null,
): Gain {
  const stop = stopIn(page, { ...next, shape }, handles);
  return {
    got: stop?.got ?? null,
    fold: report.sharpestFold?.after ?? null,
    spoilt: measures ? spoiltPanels(measures.damage).length : 0,
    damage: measures ? damageWords(measures.damage, measures.health) : "",
  };
}

/** Tries all of `ways`, in this order; what is tried already, or has been, is not tried again. */
export async function tryWays(page: Page, ways: readonly WayOn[]): Promise<void> {
  const [design, mesh, of] = [page.history.value?.present, page.mesh.value, stopped(page).value];
  const { now, solver } = tries(page);
  if (!design || !mesh || !of || now.peek()?.of === of) return;
  if (mesh.positions.length > 3 * MOST_POINTS) return;
  const known = new Map<string, Gain>();
  now.value = { of, known, done: false };
  const tell = (done: boolean): void => {
    if (now.peek()?.of === of) now.value = { of, known: new Map(known), done };
  };
  try {
    await solver.run(async (ask) => {
      await ask(openKnownQuestion(baseOf(design), mesh), "opened");
      for (const way of ways) {
        const asked = askedBy(page, design, way, of.growth);
        const { next, limit } = asked;
        const question = editQuestion(next, limit ? "release" : "solve", { limit });
        try {
          const { shape, report } = await ask(question, "shown");
          if (!shape) continue;
          const { measures } = await ask({ kind: "measure", shape }, "panels");
          known.set(way.label, gainOf(page, asked, { shape, report }, measures));
        } catch {
          // Refused: this way has no figure.
        }
        tell(false);
      }
    });
    solver.end();
    tell(true);
  } catch (error) {
    if (error instanceof GivenUp) return;
    now.value = null; // a second solver cannot be had here: the ways stay without figures
  }
}

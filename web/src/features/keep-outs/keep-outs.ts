// SPDX-License-Identifier: MIT
// Where nothing of an edit may go, and to change it. One may be moved in the view: it is drawn where it
// would be, and is there once it is let go.
import { computed, signal } from "@preact/signals";
import { FIRST_SETTINGS, type Point } from "../../design/design.ts";
import {
  firstKeepOut,
  type KeepOut,
  keepOutMoved,
  keepOutOf,
  keepOutOfTriangles,
  keepOutText,
  type PlainKind,
  problemOf,
  readKeepOut,
} from "../../design/keep-outs.ts";
import { extentOf } from "../../mesh/extent.ts";
import { niceStep } from "../../quantity/units.ts";
import { refuse } from "../../result/result.ts";
import { FILE_FORMATS, namesOfFormats } from "../../solver/file-formats.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import { commitSettings, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";

const textsOf = (page: Page): readonly string[] => (page.settings.value ?? FIRST_SETTINGS).keepOuts;

/** In the order in which they are listed. */
export const keepOuts = kept((page) =>
  computed((): readonly KeepOut[] =>
    textsOf(page).flatMap((text) => {
      const read = readKeepOut(text);
      return read ? [read] : [];
    }),
  ),
);

export const clearanceOf = (page: Page): number =>
  (page.settings.value ?? FIRST_SETTINGS).clearance;

/** Which of them is being moved in the view; null for none. */
export const movedInView = kept(() => signal<number | null>(null));

/** Points that they hold back. */
export function heldByKeepOuts(page: Page): readonly number[] {
  const { bounds, movedVertices } = page.figures.value;
  return movedVertices === 0 ? [] : (bounds?.["keep-out"] ?? []);
}

const commitAll = (page: Page, all: readonly KeepOut[]): Outcome =>
  commitSettings(
    page,
    all.length > 0
      ? { keepOuts: all.map(keepOutText) }
      : { keepOuts: [], clearance: FIRST_SETTINGS.clearance },
  );

/** Adds a keep-out beside the design that is shown, or the points that are selected. */
export function addKeepOut(page: Page, kind: PlainKind): Outcome {
  const mesh = page.mesh.value;
  if (!mesh) return Promise.resolve(undefined);
  const around = {
    extent: extentOf(mesh.positions),
    chosen: page.selection.value.map((vertex) => shownPoint(page, vertex)),
    step: niceStep(mesh.report.meanEdge / 10),
  };
  return commitAll(page, [...keepOuts(page).value, firstKeepOut(kind, around)]);
}

/** A model from a file, where it stands there. */
export async function addModel(page: Page, file: File): Outcome {
  const { name } = file;
  const format = FILE_FORMATS.find((f) => name.toLowerCase().endsWith(`.${f}`));
  const question = format && ({ kind: "readModel", file, name, format } as const);
  const read = await enqueue(page, async () =>
    question
      ? run(page, `reading ${name}`, question, "readModel")
      : refuse(`${name} cannot be read. Use an ${namesOfFormats()} file.`),
  );
  if (!read?.ok) return read;
  const one = keepOutOf(read.value.model);
  const problem = problemOf(one);
  if (problem) return enqueue(page, async () => refuse(`${name}: ${problem}`));
  return commitAll(page, [...keepOuts(page).value, one]);
}

/** The surfaces that lie beside the panels of the file, where they stand. */
export function addContext(page: Page): Outcome {
  const one = keepOutOfTriangles(page.context.value?.triangles ?? new Float64Array());
  const problem = problemOf(one);
  if (problem) return enqueue(page, async () => refuse(problem));
  return commitAll(page, [...keepOuts(page).value, one]);
}

/** What cannot be is refused, and changes nothing. */
export function changeKeepOut(page: Page, place: number, to: KeepOut): Outcome {
  const problem = problemOf(to);
  if (problem) return Promise.resolve(refuse(problem));
  return commitAll(
    page,
    keepOuts(page).value.map((one, k) => (k === place ? to : one)),
  );
}

export function moveKeepOut(page: Page, place: number, by: Point): Outcome {
  const one = keepOuts(page).value[place];
  return one ? changeKeepOut(page, place, keepOutMoved(one, by)) : Promise.resolve(undefined);
}

export function removeKeepOut(page: Page, place: number): Outcome {
  movedInView(page).value = null;
  return commitAll(
    page,
    keepOuts(page).value.filter((_, k) => k !== place),
  );
}

export function removeKeepOuts(page: Page): Outcome {
  movedInView(page).value = null;
  return commitAll(page, []);
}

/** Model units, kept from all of them. */
export const keepClear = (page: Page, clearance: number): Outcome =>
  clearance >= 0
    ? commitSettings(page, { clearance })
    : Promise.resolve(refuse("The clearance must be 0 or more."));

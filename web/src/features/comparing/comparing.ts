// SPDX-License-Identifier: MIT
// Two to four designs of one mesh, held against each other.

import { batch, computed, effect, signal, untracked } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import { convert, type Unit } from "../../quantity/units.ts";
import type { OpenedMesh, PanelMeasures, Shape } from "../../solver/protocol.ts";
import { displayOfShape } from "../../solver/shape-display.ts";
import { client } from "../../state/connection.ts";
import { goToTab } from "../../state/inspector.ts";
import { kept, type Page } from "../../state/page.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { largestShortfall } from "../../state/shortfall.ts";
import { sameMesh } from "../../state/showing.ts";
import { countTypesOf, type TypeCount } from "../../state/type-counts.ts";
import type { Command } from "../../ui/commands/command.ts";
import { door } from "../../ui/commands/doors.ts";

const MOST_COMPARED = 4;

export interface Candidate {
  /** The id of the snapshot; "" for the design shown. */
  readonly id: string;
  readonly name: string;
  readonly design: Design;
}

export interface Figures {
  readonly moved: number;
  /** Panels to be made again. */
  readonly changed: number;
  readonly spoilt: number;
  /** Degrees. */
  readonly fold: number;
  readonly angle: number;
  /** Square metres. */
  readonly area: number;
  /** Model units; null in records from before it was measured. */
  readonly slide: number | null;
  /** How far a handle is from its target at most, model units; null without handles, and of a variation. */
  readonly short: number | null;
  /** How sharply the edit bends at most, by its own operator, model units. */
  readonly bend: number;
  /** That operator: bends by different ones say nothing of each other. */
  readonly fairness: Design["settings"]["fairness"];
  /** undefined until they are counted, which comes last; null where they could not be. */
  readonly types: TypeCount | null | undefined;
}

/** The design shown and the snapshots of its mesh. */
export const candidates = kept((page) =>
  computed((): readonly Candidate[] => {
    const present = page.history.value?.present;
    if (!present) return [];
    const same = page.snapshots.value.filter(({ design }) => sameMesh(design, present));
    return [{ id: "", name: "Now", design: present }, ...same];
  }),
);

/** Ids, in the order of the candidates; the first is what the others are held against. */
export const chosen = kept(() => signal<readonly string[]>([]));

export const compared = kept((page) =>
  computed(() => candidates(page).value.filter(({ id }) => chosen(page).value.includes(id))),
);

/** The figures of each design that is compared, by id, as they arrive. */
export const comparedFigures = kept(() => signal<ReadonlyMap<string, Figures>>(new Map()));

/** The first two to four: snapshots before the design shown, unless that is none of them. */
export function chooseFirst(page: Page): void {
  const [now, ...kept] = candidates(page).value;
  const isKept = kept.some(({ design }) => design === now?.design);
  const ids = kept.map(({ id }) => id);
  const all = isKept && ids.length > 1 ? ids : ["", ...ids];
  batch(() => {
    comparedFigures(page).value = new Map();
    chosen(page).value = all.slice(0, MOST_COMPARED);
  });
}

export function toggleChosen(page: Page, id: string): void {
  const was = chosen(page).value;
  const next = was.includes(id) ? was.filter((one) => one !== id) : [...was, id];
  if (next.length >= 2 && next.length <= MOST_COMPARED) chosen(page).value = next;
}

/** The area vector's length by Newell's sum about the first corner, display units squared. */
function areaOf(points: Float32Array, corners: Int32Array): number {
  const [first = 0] = corners;
  const arm = (v: number, axis: number) =>
    (points[3 * v + axis] ?? 0) - (points[3 * first + axis] ?? 0);
  const sum = [0, 0, 0];
  for (let k = 1; k + 1 < corners.length; ++k) {
    const [v, w] = [corners[k] ?? 0, corners[k + 1] ?? 0];
    for (let axis = 0; axis < 3; ++axis) {
      const [i, j] = [(axis + 1) % 3, (axis + 2) % 3];
      sum[axis] = (sum[axis] ?? 0) + arm(v, i) * arm(w, j) - arm(v, j) * arm(w, i);
    }
  }
  return Math.hypot(...sum) / 2;
}

/** Square metres. */
function largestPanel(opened: OpenedMesh, shape: Shape, modelUnit: Unit): number {
  const { offsets, vertices, report } = opened;
  const points = displayOfShape(opened, shape);
  let largest = 0;
  for (let f = 0; f + 1 < offsets.length; ++f)
    largest = Math.max(largest, areaOf(points, vertices.subarray(offsets[f], offsets[f + 1])));
  return largest * convert(1 / report.scale, modelUnit, "m") ** 2;
}

const HEALTH = { angle: 2, stride: 4 } as const;

const largest = (values: Float32Array | null): number =>
  values?.reduce((most, value) => Math.max(most, value), 0) ?? 0;

function figuresOf(
  page: Page,
  design: Design,
  measures: PanelMeasures,
  opened: OpenedMesh,
): Figures {
  const { shape, report } = design;
  const { health, damage, folds, bending } = measures;
  let angle = 180;
  for (let k = HEALTH.angle; k < health.length; k += HEALTH.stride)
    angle = Math.min(angle, health[k] ?? angle);
  return {
    moved: shape.moved.length,
    changed: countHealth(health).changed,
    spoilt: damage.reduce((count, kind) => count + (kind > 0 ? 1 : 0), 0),
    fold: largest(folds),
    angle,
    area: largestPanel(opened, shape, page.unit.value),
    slide: report.motion?.slide ?? null,
    short: largestShortfall(page, design),
    bend: largest(bending),
    fairness: design.settings.fairness,
    types: undefined,
  };
}

function remember(page: Page, id: string, figures: Figures): void {
  comparedFigures(page).value = new Map([...comparedFigures(page).value, [id, figures]]);
}

/** Questions about designs, which stop once nobody wants their answers. */
interface Run {
  readonly over: () => boolean;
}

async function measureAll(page: Page, opened: OpenedMesh, { over }: Run): Promise<void> {
  for (const { id, design } of compared(page).peek()) {
    if (comparedFigures(page).peek().has(id)) continue;
    const { shape, settings } = design;
    const answer = await client(page)
      .ask({ kind: "measure", shape, fairness: settings.fairness })
      .catch(() => null);
    if (over() || answer?.kind !== "panels" || !answer.measures) return;
    remember(page, id, figuresOf(page, design, answer.measures, opened));
  }
}

async function countAll(page: Page, { over }: Run): Promise<void> {
  for (const { id, design } of compared(page).peek()) {
    const figures = comparedFigures(page).peek().get(id);
    if (over() || !figures || figures.types !== undefined) continue;
    const types = await countTypesOf(page, design.shape);
    if (!over()) remember(page, id, { ...figures, types });
  }
}

/** The run that goes on, or went last: the next one waits until it has ended. */
const lastRun = kept(() => ({ ended: Promise.resolve() }));

/** Measures the compared designs that have no figures yet; then counts their types. */
async function measureCompared(page: Page, isStopped: () => boolean): Promise<void> {
  const opened = page.mesh.peek();
  const run = { over: () => isStopped() || opened !== page.mesh.peek() };
  await lastRun(page).ended;
  if (!opened || run.over()) return;
  await measureAll(page, opened, run);
  await countAll(page, run);
}

/** Measures what is compared, whenever that changes, until it is stopped. */
export const followCompared = (page: Page): (() => void) =>
  effect(() => {
    compared(page).value;
    let stopped = false;
    const run = untracked(() => measureCompared(page, () => stopped));
    lastRun(page).ended = run;
    return () => {
      stopped = true;
    };
  });

export const compareDoor = door();

export const COMPARE: Command = {
  label: "Compare",
  refusal: (page) => (candidates(page).value.length > 1 ? "" : "It needs a snapshot of this mesh."),
  run: (page) => {
    goToTab(page, "explore");
    return compareDoor(page).open();
  },
};

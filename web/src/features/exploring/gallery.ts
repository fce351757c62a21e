// SPDX-License-Identifier: MIT
// A few variations side by side, each made exact before it is shown, so that it can be adopted as
// it is.

import { signal } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import * as steps from "../../design/history.ts";
import type { Shape, ShapeReport } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { client, runUnseen } from "../../state/connection.ts";
import { damageWords } from "../../state/damage.ts";
import { goToTab } from "../../state/inspector.ts";
import { kept, type Page } from "../../state/page.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { showOnly, showStep } from "../../state/showing.ts";
import { keepSnapshot } from "../../state/snapshots.ts";
import { countTypes, type TypeCount } from "../../state/type-counts.ts";
import { ensureDirections, explore } from "./exploring.ts";
import { furthestBetween, reachOf } from "./furthest.ts";
import { isInside, within } from "./slider-range.ts";
import { stopsAt } from "./slider-stops.ts";

export interface GalleryItem {
  readonly coefficients: readonly number[];
  readonly shape: Shape;
  readonly report: ShapeReport;
  /** null until it has been measured. */
  readonly panels: GalleryPanels | null;
}

export interface GalleryPanels {
  /** To be made again. */
  readonly changed: number;
  /** "1 panel became concave"; "" where none is spoilt. */
  readonly damage: string;
  /** null where nobody asked for types. */
  readonly types: TypeCount | null;
}

export interface Gallery {
  /** The shape whose directions these are. */
  readonly centre: Shape;
  readonly items: readonly GalleryItem[];
  /** How many there will be, unless some cannot be made flat. */
  readonly planned: number;
  /** How many were left out, being as near to the edit or to one of these as SAME says. */
  readonly alike: number;
}

export const gallery = kept(() => signal<Gallery | null>(null));

const SIZE = 9;
/** How far from the edit, as a share of what the sliders allow. */
const STEP = 0.7;
/** Sliders that stop one another come closer by this, at most so often. */
const [NEARER, TIMES] = [0.75, 6];

/** Coefficients of up to SIZE different designs in `dimension` directions. */
export function candidates(dimension: number): number[][] {
  const unit = (index: number, value: number): number[] =>
    Array.from({ length: dimension }, (_, k) => (k === index ? value : 0));
  if (dimension === 1) return [-1, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 1].map((x) => [x]);
  const all: number[][] = [];
  for (let k = 0; k < dimension; ++k) all.push(unit(k, STEP), unit(k, -STEP));
  for (let a = 0; a < dimension && all.length < SIZE; ++a) {
    for (let b = a + 1; b < dimension && all.length < SIZE; ++b) {
      for (const sign of [1, -1]) {
        const half = STEP * Math.SQRT1_2;
        all.push(unit(a, half).map((x, k) => (k === b ? sign * half : x)));
        all.push(unit(a, -half).map((x, k) => (k === b ? sign * half : x)));
      }
    }
  }
  return all.slice(0, SIZE);
}

/** Sliders that are set together may stop one another: then all of them come nearer to the edit. */
async function insideStops(
  page: Page,
  centre: Shape,
  asked: readonly number[],
): Promise<readonly number[]> {
  const zero = asked.map(() => 0);
  const alone = await stopsAt(page, { centre, coefficients: zero });
  if (!alone) return asked;
  let x = within(asked, alone);
  for (let k = 0; k < TIMES; ++k) {
    const there = await stopsAt(page, { centre, coefficients: x });
    if (!there || isInside(x, there)) break;
    x = x.map((value) => NEARER * value);
  }
  return x;
}

/** Nearer to the edit a design would be the same to the eye. */
const LEAST = 0.05;
/** Of how far the edit moves points: designs all of whose points are nearer to each other's than this look the
 * same. Limits may hold all of them back at one shape. */
const SAME = 0.02;

/** Model units. */
export const sameWithin = (centre: Shape, base: Float64Array): number =>
  SAME * reachOf(centre, base);

/** Whether it looks like the edit, or like one that is there. */
function isAlike(page: Page, { centre, items }: Gallery, shape: Shape): boolean {
  const opened = page.mesh.value;
  if (!opened) return false;
  const least = sameWithin(centre, opened.positions);
  return [centre, ...items.map((item) => item.shape)].some((other) => {
    const found = furthestBetween(other, shape, opened.positions);
    return !found || Math.hypot(...found.move) < least;
  });
}

/** Whether the gallery's directions are those of the design shown. */
const current = (page: Page, centre: Shape): boolean =>
  page.draft.value?.variation?.centre === centre;

/** Fills the gallery one by one, giving way to whatever else is asked for. */
export async function fillGallery(page: Page): Promise<void> {
  const variation = page.draft.value?.variation;
  if (!variation || gallery(page).value?.centre === variation.centre) return;
  const { centre, coefficients } = variation;
  const planned = candidates(coefficients.length);
  gallery(page).value = { centre, items: [], planned: planned.length, alike: 0 };
  for (const [k, x] of planned.entries()) {
    let going = false;
    await enqueue(page, async () => {
      const design = page.history.value?.present;
      if (!design || !current(page, centre) || gallery(page).value?.centre !== centre) return;
      const there = await ensureDirections(page, design);
      if (!there.ok) return there;
      going = await addItem(page, x, k + 1, planned.length);
    });
    if (!going) break;
  }
  const { value } = gallery(page);
  if (value?.centre === centre) gallery(page).value = { ...value, planned: value.items.length };
}

/** A variation that cannot be made flat is left out; false only if the search was stopped. */
async function addItem(
  page: Page,
  x: readonly number[],
  number: number,
  total: number,
): Promise<boolean> {
  const label = `variation ${number} of ${total}`;
  const centre = gallery(page).value?.centre;
  const coefficients = centre ? await insideStops(page, centre, x) : x;
  if (Math.hypot(...coefficients) < LEAST) return true;
  const answer = await runUnseen(page, label, { kind: "project", coefficients }, "projected");
  if (!answer.ok) return answer.reason !== "";
  const filling = gallery(page).value;
  if (!filling) return false;
  const { shape, report } = answer.value;
  if (isAlike(page, filling, shape)) {
    gallery(page).value = { ...filling, alike: filling.alike + 1 };
    return true;
  }
  const panels = await panelsOf(page, shape);
  const item = { coefficients, shape, report, panels };
  gallery(page).value = { ...filling, items: [...filling.items, item] };
  return true;
}

async function panelsOf(page: Page, shape: Shape): Promise<GalleryPanels | null> {
  try {
    const answer = await client(page).ask({ kind: "measure", shape });
    if (answer.kind !== "panels" || !answer.measures) return null;
    const { health, damage } = answer.measures;
    const types = await countTypes(page, shape);
    return { changed: countHealth(health).changed, damage: damageWords(damage, health), types };
  } catch {
    return null;
  }
}

/** Shows a variation of the gallery while the pointer rests on it; nothing else happens. */
export function preview(page: Page, item: GalleryItem | null): void {
  const steady = page.history.value?.present;
  if (!steady || page.draft.value !== steady || page.busy.value) return;
  showOnly(page, item ? { ...steady, shape: item.shape } : steady);
}

/** A variation of the gallery as a design; null where its sliders are not those of the design shown. */
function designOf(page: Page, { coefficients, shape, report }: GalleryItem): Design | null {
  const design = page.history.value?.present;
  if (!design?.variation) return null;
  const variation = { ...design.variation, coefficients, exact: true };
  return { ...design, shape, report, variation };
}

/** Makes one of the gallery the design, as one step of the history. */
export const adopt = (page: Page, item: GalleryItem): Outcome =>
  enqueue(page, async () => {
    const next = designOf(page, item);
    if (!page.history.value || !next || page.history.value.present.shape === item.shape) return;
    page.notice.value = null;
    return showStep(page, next, steps.record(page.history.value, next));
  });

/** Keeps one of the gallery as a snapshot; the design stays. */
export const keep = (page: Page, item: GalleryItem): Outcome =>
  enqueue(page, async () => {
    const design = designOf(page, item);
    if (design) keepSnapshot(page, design);
  });

/** Finds the sliders of the edit, shows where they are, and fills the gallery beside them. */
export async function findVariations(page: Page): Promise<void> {
  goToTab(page, "explore");
  await explore(page);
  await fillGallery(page);
}

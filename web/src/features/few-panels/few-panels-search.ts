// SPDX-License-Identifier: MIT
// The curve of an edit, panels made again against its sharpest fold: computed beside the solver while the
// page goes on, given up at any time; each point of it is a design that can be taken.

import { computed, signal } from "@preact/signals";
import { type Design, type HandleRow, toTargets } from "../../design/design.ts";
import * as steps from "../../design/history.ts";
import type { OpenedMesh, Shape } from "../../solver/protocol.ts";
import { type Ask, GivenUp, type News, SecondSolver } from "../../solver/second-solver.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { baseOf, openKnownQuestion } from "../../state/connection.ts";
import { basePoint, longestWay } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { showOnly, showStep } from "../../state/showing.ts";
import { type CurvePoint, cutAgain, type Way, WITHIN_HANDLE, waysOf } from "./edit-curve.ts";

const BUDGET = 0; // of frames alone

export interface EditCurve {
  /** The edit as it is, which is its first point. */
  readonly of: Design;
  readonly points: readonly CurvePoint[];
  /** How many ways there are to compute, the edit as it is beside them. */
  readonly planned: number;
  readonly done: number;
  /** What is computed now; null while nothing is. */
  readonly doing: string | null;
  /** Of the solver, in what is computed now. */
  readonly step: number;
  /** Why a way gave no point. */
  readonly problems: readonly string[];
}

const found = kept(() => signal<EditCurve | null>(null));

interface Own {
  /** Lets the running search go. */
  stop: (() => void) | null;
  /** The last burst of keys and what it took. */
  latest: { readonly burst: string; readonly design: Design } | null;
}

const own = kept((): Own => ({ stop: null, latest: null }));

const isOn = (curve: EditCurve, design: Design): boolean =>
  curve.of === design || curve.points.some((point) => point.design === design);

/** The curve that the design is on. */
export const curve = kept((page) =>
  computed((): EditCurve | null => {
    const [known, design] = [found(page).value, page.history.value?.present];
    return known && design && isOn(known, design) ? known : null;
  }),
);

/** What was found so far stays. */
export function stopSearch(page: Page): void {
  own(page).stop?.();
}

/** A search for a design that is no more there only warms the machine. */
export function stopWhereLeft(page: Page): void {
  const design = page.history.value?.present;
  const known = found(page).peek();
  if (known?.doing && design && !isOn(known, design)) stopSearch(page);
}

/** Finds the points of the present edit one by one. `most`: of panels, that one alone; 0: all. */
export async function findCurve(page: Page, most = 0): Promise<void> {
  stopSearch(page);
  const [of, mesh] = [page.history.peek()?.present, page.mesh.peek()];
  if (!of || !mesh) return;
  const search = new CurveSearch(page, of, mesh, most);
  own(page).stop = () => search.stop();
  await search.run();
}

/** One search; stopped, it changes nothing any more. */
class CurveSearch {
  readonly #page: Page;
  readonly #of: Design;
  readonly #mesh: OpenedMesh;
  readonly #solver: SecondSolver;
  readonly #most: number;
  #going = true;

  constructor(page: Page, of: Design, mesh: OpenedMesh, most: number) {
    this.#page = page;
    this.#of = of;
    this.#mesh = mesh;
    this.#most = most;
    this.#solver = new SecondSolver(page.spawn);
  }

  stop(): void {
    if (!this.#going) return;
    this.#tell({ doing: null });
    this.#going = false;
    this.#solver.end();
  }

  async run(): Promise<void> {
    const ways = waysOf(this.#of, this.#page.statedLimits.peek(), this.#most);
    found(this.#page).value = {
      of: this.#of,
      points: [],
      planned: ways.length,
      done: 0,
      doing: "the mesh",
      step: 0,
      problems: [],
    };
    try {
      await this.#solver.run(async (ask) => {
        await this.#begin(ask);
        for (const way of ways) await this.#add(ask, way);
      });
    } catch (error) {
      if (!(error instanceof GivenUp)) this.#complain(error);
    }
    this.stop();
  }

  #tell(change: Partial<EditCurve>): void {
    const { value } = found(this.#page);
    if (this.#going && value?.of === this.#of) found(this.#page).value = { ...value, ...change };
  }

  readonly #step = (news: News): void => {
    if (news.kind === "progress") this.#tell({ step: news.step });
  };

  #complain(error: unknown, label = ""): void {
    const sentence = error instanceof Error ? error.message : String(error);
    const problems = found(this.#page).peek()?.problems ?? [];
    this.#tell({ problems: [...problems, label ? `${label}: ${sentence}` : sentence] });
  }

  /** Opens the page's mesh in this solver, and notes the edit as it is. */
  async #begin(ask: Ask): Promise<void> {
    await ask(openKnownQuestion(baseOf(this.#of), this.#mesh), "opened", this.#step);
    const panels = await this.#panelsOf(ask, this.#of.shape);
    this.#addPoint({ label: "As it is", design: this.#of, panels, minimal: null });
  }

  async #panelsOf(ask: Ask, shape: Shape): Promise<number> {
    const copy = { moved: shape.moved.slice(), positions: shape.positions.slice() };
    const question = { kind: "measure", shape: copy } as const;
    const { measures } = await ask(question, "panels");
    return cutAgain(measures.health);
  }

  #addPoint(point: CurvePoint): void {
    this.#tell({ points: [...(found(this.#page).peek()?.points ?? []), point] });
  }

  async #add(ask: Ask, way: Way): Promise<void> {
    this.#tell({ doing: way.label, step: 0 });
    try {
      const point = await this.#compute(ask, way);
      if (point) this.#addPoint(point);
    } catch (error) {
      this.#complain(error, way.label);
    }
    this.#tell({ done: (found(this.#page).peek()?.done ?? 0) + 1 });
  }

  /** null where the handles do not arrive. */
  #compute(ask: Ask, way: Way): Promise<CurvePoint | null> {
    return way.kind === "fewest" ? this.#fewest(ask, way) : this.#edit(ask, way);
  }

  async #fewest(ask: Ask, { label, settings, most }: Way): Promise<CurvePoint | null> {
    const targets = toTargets(this.#of.handles);
    const asked = { targets, settings, withinHandle: WITHIN_HANDLE, mostPanels: most };
    const question = { kind: "fewest", ...asked } as const;
    const answer = await ask(question, "fewest", this.#step);
    const { shape, report, found: few } = answer;
    if (!few.reached) return this.#shortOf(label);
    if (most > 0 && few.panels > most)
      this.#complain(new Error(`${few.panels} are the fewest that were found.`), label);
    const design: Design = {
      ...this.#of,
      handles: [...this.#of.handles, ...this.#pinsAt([...few.held])],
      settings: { ...settings, limits: few.limits },
      shape,
      report,
      variation: null,
    };
    return { label, design, panels: await this.#panelsOf(ask, shape), minimal: few.minimal };
  }

  async #edit(ask: Ask, { label, settings }: Way): Promise<CurvePoint | null> {
    const targets = toTargets(this.#of.handles);
    const asked = { mode: "solve", targets, settings, budget: BUDGET } as const;
    const question = { kind: "edit", ...asked, limit: null, reaches: [], sought: null } as const;
    const { shape, report } = await ask(question, "shown", this.#step);
    const near = WITHIN_HANDLE * longestWay(this.#page, this.#of.handles);
    if (!shape || report.handleError > near) return this.#shortOf(label);
    const design: Design = { ...this.#of, settings, shape, report, variation: null };
    return { label, design, panels: await this.#panelsOf(ask, shape), minimal: null };
  }

  #shortOf(label: string): null {
    this.#complain(new Error("the points do not arrive."), label);
    return null;
  }

  /** What is held are pins of the design, as on the command line. */
  #pinsAt(held: readonly number[]): HandleRow[] {
    const at = (vertex: number) => basePoint(this.#page, vertex);
    return held.map((vertex) => ({ vertex, target: at(vertex), pinned: true }));
  }
}

/** Makes a point of the curve the design, as one step of the history; keys one after the other are one. */
export const take = (page: Page, { design }: CurvePoint, burst: string | null = null): Outcome =>
  enqueue(
    page,
    async () => {
      const { value } = page.history;
      if (!value || !curve(page).peek()) return;
      if (value.present === design) {
        showOnly(page, design);
        return;
      }
      const { latest } = own(page);
      const goesOn = burst !== null && latest?.burst === burst && latest.design === value.present;
      page.notice.value = null;
      const record = goesOn ? steps.amend : steps.record;
      const refusal = await showStep(page, design, record(value, design));
      own(page).latest = burst !== null && !refusal ? { burst, design } : null;
      return refusal;
    },
    burst,
  );

/** Shows a point of the curve in place of the design, which stays; null: the design again. */
export function look(page: Page, point: CurvePoint | null): void {
  const steady = page.history.peek()?.present;
  if (!steady || page.draft.peek() !== steady || page.busy.peek()) return;
  showOnly(page, point ? { ...steady, shape: point.design.shape } : steady);
}

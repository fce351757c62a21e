// SPDX-License-Identifier: MIT
// A drag that panels did not follow in time goes on behind what is shown, to where it was let go, in a solver of
// its own: whatever else is done ends it, and what is there stays.

import { effect, signal } from "@preact/signals";
import type { Design } from "../../design/design.ts";
import * as steps from "../../design/history.ts";
import { SecondSolver } from "../../solver/second-solver.ts";
import { enqueue } from "../../state/action-queue.ts";
import { baseOf, openKnownQuestion } from "../../state/connection.ts";
import { spoiltPanels } from "../../state/damage.ts";
import { designOf, editQuestion } from "../../state/editing.ts";
import { lastLeftBehind } from "../../state/left-behind.ts";
import { kept, type Page } from "../../state/page.ts";
import { lastRefusedPull } from "../../state/refused-pull.ts";
import { showStep } from "../../state/showing.ts";
import { type Asked, askedBy, type Stopped, stopIn, stopped } from "./going-on.ts";
import { isNoFurther, within } from "./way-on.ts";

/** Of a mesh: a second solver of a larger one takes a gigabyte. */
const MOST_POINTS = 300_000;

export const CATCHING_UP = "Panels follow slowly here: going on to where you let go.";

const own = kept((page) => ({ running: signal(false), solver: new SecondSolver(page.spawn) }));

/** Whether a drag goes on behind what is shown. */
export const isCatchingUp = (page: Page): boolean => own(page).running.value;

/** Whether it stands as the drag left it, and nobody does anything. */
const isUntouched = (page: Page, design: Design): boolean =>
  page.history.value?.present === design &&
  page.draft.value === design &&
  page.pull.value === null &&
  !page.busy.value;

/** The edit of the whole pull within the drag's limit, if its handles get further, and it is certified and sound. */
async function furtherOn(
  page: Page,
  design: Design,
  { stop }: Stopped,
  { next, limit, handles }: Asked,
): Promise<Design | null> {
  const { value: mesh } = page.mesh;
  if (!mesh) return null;
  const question = editQuestion(next, "release", { limit });
  return own(page).solver.run(async (ask) => {
    await ask(openKnownQuestion(baseOf(design), mesh), "opened");
    const answer = await ask(question, "shown");
    const made = answer.shape && designOf(next, question, { ...answer, shape: answer.shape });
    if (made?.report.status !== "converged") return null;
    const after = stopIn(page, made, handles);
    if (after && isNoFurther(after.got, stop)) return null;
    const { measures } = await ask({ kind: "measure", shape: made.shape }, "panels");
    return spoiltPanels(measures.damage).length === 0 ? made : null;
  });
}

/** Takes the place of `before`, in the same step of the history. */
const take = (
  page: Page,
  before: Design,
  made: Design,
  { handles }: Asked,
  growth: number | null,
) =>
  enqueue(page, async () => {
    const history = page.history.value;
    if (history?.present !== before || page.draft.value !== before) return;
    const refusal = await showStep(page, made, steps.amend(history, made));
    if (refusal) return refusal;
    const all = made.handles === handles;
    lastRefusedPull(page).value = all ? null : { handles, growth, dragged: false, design: made };
    return undefined;
  });

/** Of the drag that ended last, once: ends where it gets further, or with whatever is done next. */
export async function catchUp(page: Page): Promise<void> {
  const [design, found] = [lastLeftBehind(page).peek(), stopped(page).peek()];
  if (!design || !found || !isUntouched(page, design)) return;
  const { running, solver } = own(page);
  lastLeftBehind(page).value = null;
  if ((page.mesh.peek()?.positions.length ?? 0) > 3 * MOST_POINTS) return;
  const asked = askedBy(page, design, within(found.growth), found.growth);
  const said = page.notice.peek();
  running.value = true;
  page.notice.value = CATCHING_UP;
  const off = effect(() => {
    if (!isUntouched(page, design)) solver.end();
  });
  let made: Design | null = null;
  try {
    made = await furtherOn(page, design, found, asked);
  } catch {
    // Given up, refused, or no second solver: what is there stays.
  }
  off();
  solver.end();
  if (page.notice.peek() === CATCHING_UP) page.notice.value = made ? null : said;
  if (made) await take(page, design, made, asked, found.growth);
  running.value = false;
}

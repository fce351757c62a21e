// SPDX-License-Identifier: MIT
// The cuts of the design that is open: made before its edit, each one more step of the history.
import { computed } from "@preact/signals";
import { FIRST_SETTINGS } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { refuse } from "../../result/result.ts";
import type { Question } from "../../solver/client.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { runUnseen } from "../../state/connection.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { commitSettings } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { cutWords } from "./cut-text.ts";

/** Cuts as --cut says them, in the order in which they are made. */
export const cuts = kept((page) =>
  computed((): readonly string[] => (page.settings.value ?? FIRST_SETTINGS).cuts),
);

const SOLVED_AGAIN = "The edit was solved again on the cut mesh.";

/** Which points lost their panels, and what became of their handles; "" where none did. */
function goneWords(gone: readonly number[]): string {
  if (gone.length === 0) return "";
  return gone.length === 1
    ? ` Point ${gone[0]} is gone with its panels, and its handle is removed.`
    : ` ${gone.length} points are gone with their panels, and their handles are removed.`;
}

/** The edit, if there is one, is solved again on the mesh that they leave. */
async function commitCuts(page: Page, to: readonly string[], said: string): Outcome {
  if (!page.baseFlat.value) return enqueue(page, async () => refuse(FLAT_FIRST));
  const handles = page.handles.value;
  const end = await commitSettings(page, { cuts: to });
  if (!end?.ok) return end;
  const left = new Set(page.handles.value.map(({ vertex }) => vertex));
  const gone = handles.map(({ vertex }) => vertex).filter((vertex) => !left.has(vertex));
  const more = goneWords(gone) + (left.size > 0 ? ` ${SOLVED_AGAIN}` : "");
  const before = page.notice.value ? `${page.notice.value} ` : "";
  page.notice.value = `${before}${said}${more}`;
  return end;
}

export type TryCut = Extract<Question, { kind: "tryCut" }>;

/** Makes a cut, with its images where edits have some; a sentence where it cannot be made, which the tool says.
 * @param trial what the solver is asked about it before */
export async function makeCut(
  page: Page,
  text: string,
  trial: TryCut,
): Promise<Awaited<Outcome> | string> {
  const tried = await enqueue(page, () => runUnseen(page, "cutting", trial, "tried"));
  if (!tried?.ok) return tried;
  const { problem } = tried.value.trial;
  if (problem) return problem;
  const all = tried.value.trial.cuts.split("\n");
  const images = all.length > 1 ? ` and ${counted(all.length - 1, "image")}` : "";
  return commitCuts(page, [...cuts(page).value, ...all], `Cut: ${cutWords(text)}${images}.`);
}

/** Removes the cut at a place of the list and those after it, whose numbers may be of what it left. */
export const removeCuts = (page: Page, place: number): Outcome =>
  commitCuts(
    page,
    cuts(page).value.slice(0, place),
    `Removed: ${cuts(page).value.slice(place).map(cutWords).join("; ")}.`,
  );

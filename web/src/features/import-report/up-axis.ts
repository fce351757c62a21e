// SPDX-License-Identifier: MIT
// Another axis of the file goes up: the mesh is turned, as one step, like another file.
import { computed } from "@preact/signals";
import { isAsOpened } from "../../design/design.ts";
import { likelyUp, type UpAxis } from "../../mesh/up-axis.ts";
import type { Source } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import { holdAlsoFor } from "../../state/kept-groups.ts";
import { adopt } from "../../state/opening.ts";
import { kept, type Page } from "../../state/page.ts";

const turned = kept(() => new WeakMap<Source, UpAxis>());

/** The axis of the file that goes up in what is open. */
export const upAxis = kept((page: Page) =>
  computed((): UpAxis => {
    const source = page.draft.value?.source;
    return (source && turned(page).get(source)) ?? "z";
  }),
);

/** What was made of a file, whose axes it has. Before it is shown. */
export function keepUp(page: Page, source: Source, next: Source): void {
  const up = turned(page).get(source);
  if (up) turned(page).set(next, up);
}

/** What a roof with the panels of the file would have up; null where none stands out, or Z does. */
export const guessedUp = kept((page: Page) =>
  computed(() => {
    const opened = page.mesh.value;
    const up = opened && upAxis(page).value === "z" ? likelyUp(opened) : null;
    return up === "z" ? null : up;
  }),
);

/** Whether the mesh is a file's, as it was opened: whatever else there is would have to be turned, too. */
export function canTurn(page: Page): boolean {
  const design = page.draft.value;
  if (design?.source.kind !== "file" || !isAsOpened(design)) return false;
  const { keepOuts, symmetry, cuts } = design.settings;
  const stated = [...keepOuts, ...symmetry, ...cuts];
  return stated.length === 0 && !page.contexts.value.has(design.source);
}

export const turnUp = (page: Page, to: UpAxis): Outcome =>
  enqueue(page, async () => {
    const { source } = page.draft.value ?? {};
    const warnings = page.mesh.value?.report.warnings ?? [];
    // An action queued before this one may have made it flat.
    if (source?.kind !== "file" || !canTurn(page)) return;
    const question = { kind: "turn", name: source.name, from: upAxis(page).value, to } as const;
    const answer = await run(page, "turning the mesh", question, "opened");
    if (!answer.ok || !answer.value.source) return answer;
    const { source: next, mesh } = answer.value;
    turned(page).set(next, to);
    holdAlsoFor(page, next);
    adopt(page, next, null, { ...mesh, report: { ...mesh.report, warnings } });
    page.importReport.value = true;
    return answer;
  });

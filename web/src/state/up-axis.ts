// SPDX-License-Identifier: MIT
// Another axis of the file goes up: the mesh is turned, as one step, like another file.
import { computed, signal } from "@preact/signals";
import { likelyUp, type UpAxis } from "../mesh/up-axis.ts";
import type { Source } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { adopt } from "./opening.ts";
import { kept, type Page } from "./page.ts";
import { inTurn, type Outcome } from "./turns.ts";

const turned = kept(() => signal<ReadonlyMap<Source, UpAxis>>(new Map()));

/** The axis of the file that goes up in what is open. */
export const upAxis = kept((page: Page) =>
  computed((): UpAxis => {
    const source = page.draft.value?.source;
    return (source && turned(page).value.get(source)) ?? "z";
  }),
);

/** What a roof with the panels of the file would have up; null where none stands out, or Z does. */
export const guessedUp = kept((page: Page) =>
  computed(() => {
    const opened = page.mesh.value;
    const up = opened && upAxis(page).value === "z" ? likelyUp(opened) : null;
    return up === "z" ? null : up;
  }),
);

/** Whether the mesh is a file's, as it was opened: what was done since would have to be turned, too. */
export function canTurn(page: Page): boolean {
  const design = page.draft.value;
  const untouched = design?.planarised === null && design.handles.length === 0;
  return design?.source.kind === "file" && untouched;
}

export const turnUp = (page: Page, to: UpAxis): Outcome =>
  inTurn(page, async () => {
    const { source } = page.draft.value ?? {};
    if (source?.kind !== "file") return;
    const question = { kind: "turn", name: source.name, from: upAxis(page).value, to } as const;
    const answer = await run(page, "turning the mesh", question, "opened");
    if (!answer.ok || !answer.value.source) return answer;
    turned(page).value = new Map([...turned(page).value, [answer.value.source, to]]);
    adopt(page, answer.value.source, null, answer.value.mesh);
    page.importReport.value = true;
    return answer;
  });

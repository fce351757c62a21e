// SPDX-License-Identifier: MIT
// The design shown with more of its panels alike: another mesh, one step of the history.

import { type Design, sourceName } from "../../design/design.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength } from "../../quantity/units.ts";
import type { AlikeMesh } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import { adopt, readMade } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";

/** What may change so that more panels are alike. */
export interface AlikeChoice {
  /** At most so many types; 0: within what the legend counts with. */
  readonly types: number;
  /** Of any point, a share of the mean edge. */
  readonly move: number;
  readonly keepBoundary: boolean;
}

/** "roof.obj", "roof, alike.obj" */
const alikeName = (name: string): string => `${name.replace(/\.[a-z]{3}$/i, "")}, alike.obj`;

function askedOf(page: Page, { settings }: Design, choice: AlikeChoice) {
  const { share, mirrored } = page.typesChoice.value;
  const stated = page.statedLimits.value;
  const limits = settings.limits.filter((limit) => stated.includes(limit));
  return { ...choice, within: share, mirrored, tolerance: settings.tolerance, limits };
}

function madeWords(page: Page, { before, after, within, maxMove, reached }: AlikeMesh): string {
  const [corners, move] = [within, maxMove].map((length) => formatLength(length, page.unit.value));
  const types = `${counted(after, "type")} in place of ${before}${reached ? "" : ", more than asked for"}`;
  return `${types}, corners within ${corners}; points moved by up to ${move}. Edits start from this mesh; Undo brings the design back.`;
}

function noFewerWords(page: Page, { before, within, reached }: AlikeMesh, most: number): string {
  const [types, corners] = [counted(before, "type"), formatLength(within, page.unit.value)];
  return most > 0 && reached
    ? `With corners within ${corners} the design has ${types} as it is: no closer fit was found.`
    : `No fewer than ${types} were found with corners within ${corners}. Longer moves, or a boundary that moves, may have fewer.`;
}

export const makeAlike = (page: Page, choice: AlikeChoice): Outcome =>
  enqueue<unknown>(page, async () => {
    const design = page.draft.value;
    if (!design) return;
    const asked = askedOf(page, design, choice);
    const answer = await run(page, "making panels alike", { kind: "alike", asked }, "alike");
    if (!answer.ok) return answer;
    const { made } = answer.value;
    if (made.after >= made.before) {
      page.notice.value = noFewerWords(page, made, choice.types);
      return answer;
    }
    const name = alikeName(sourceName(design.source));
    const read = await readMade(page, "opening the mesh with panels alike", name, made.file);
    if (!read.ok) return read;
    adopt(page, read.value.source, null, read.value.mesh);
    if (choice.types > 0) page.typesChoice.value = { ...page.typesChoice.value, share: made.share };
    page.notice.value = madeWords(page, made);
    return read;
  });

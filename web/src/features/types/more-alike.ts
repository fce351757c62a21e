// SPDX-License-Identifier: MIT
// The design shown with more of its panels alike: another mesh, one step of the history.

import { sourceName } from "../../design/design.ts";
import { formatLength } from "../../quantity/units.ts";
import { run } from "../../state/connection.ts";
import { adopt } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { inTurn, type Outcome } from "../../state/turns.ts";

/** The same without its extension, as an OBJ of its own. */
const fileName = (name: string): string => `${name.replace(/\.[^.]*$/, "")}-alike.obj`;

/** @param move of any point, a share of the mean edge */
export const makeAlike = (page: Page, move: number, keepBoundary: boolean): Outcome =>
  inTurn(page, async () => {
    const design = page.draft.value;
    if (!design) return;
    const { share, mirrored } = page.typesChoice.value;
    const asked = { within: share, move, mirrored, keepBoundary };
    const name = fileName(sourceName(design.source));
    const question = { kind: "alike", name, asked } as const;
    const answer = await run(page, "making panels alike", question, "alike");
    if (!answer.ok) return answer;
    const { before, after, maxMove, opened } = answer.value;
    if (!opened) {
      page.notice.value = `No fewer than ${before} types were found, with moves of that size.`;
      return answer;
    }
    adopt(page, opened.source, null, opened.mesh);
    page.notice.value = `${after} types in place of ${before}; points moved by up to ${formatLength(maxMove, page.unit.value)}. It is another mesh: Undo goes back to the design.`;
    return answer;
  });

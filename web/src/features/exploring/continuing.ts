// SPDX-License-Identifier: MIT
// The design as it stands becomes a mesh of its own, from which the next edits start.

import { sourceName } from "../../design/design.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import { holdAlsoFor } from "../../state/kept-groups.ts";
import { adopt, readMade } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";

const CONTINUED = /, continued(?: (\d+))?$/;

/** "roof.obj", "roof, continued.obj", "roof, continued 2.obj" */
export function continuedName(name: string): string {
  const stem = name.replace(/\.[a-z]{3}$/i, "");
  const times = CONTINUED.exec(stem);
  if (!times) return `${stem}, continued.obj`;
  return `${stem.replace(CONTINUED, "")}, continued ${Number(times[1] ?? 1) + 1}.obj`;
}

const SAID =
  "This shape is the new start: handles and variations are cleared. Undo brings them back.";

/** Goes on from the shape as a mesh, one step of the history; OBJ keeps every bit of every coordinate. */
export const continueFromShape = (page: Page): Outcome =>
  enqueue(page, async () => {
    const design = page.history.value?.present;
    if (!design || design.shape.moved.length === 0) return;
    const label = "starting from this shape";
    const written = await run(
      page,
      label,
      { kind: "export", format: "obj", design: null, groups: null },
      "exported",
    );
    if (!written.ok) return written;
    const name = continuedName(sourceName(design.source));
    const read = await readMade(page, label, name, written.value.bytes);
    if (!read.ok) return read;
    const { source, mesh } = read.value;
    holdAlsoFor(page, source);
    adopt(page, source, null, mesh);
    page.notice.value = SAID;
    return read;
  });

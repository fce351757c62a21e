// SPDX-License-Identifier: MIT
// What the 3D view shows while a way to planarise is tried out, in a sentence or two.

import { isFlat } from "../../design/flatness.ts";
import type { Trial } from "../../design/planarising.ts";
import { formatLength } from "../../quantity/units.ts";
import type { MeshReport } from "../../solver/protocol.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";

/** What is only tried out is not there: the design is the file until it is taken. */
function trialWords(page: Page, { mesh: { report } }: Trial): string {
  const { moved, largest } = report.planarising;
  const all = isFlat(report) ? "would all be flat" : "would not all be flat";
  return (
    `A preview of planarising: ${report.faces} panels ${all}, with ${moved} of ` +
    `${report.vertices} points moved by up to ${formatLength(largest, page.unit.value)}. ` +
    "The file, which the tables are of, is not flat."
  );
}

/** "" without a preview. */
export function previewWords(page: Page, { faces, vertices }: MeshReport): string {
  const preview = page.planariseTrial.value;
  if (preview.kind === "shown") return trialWords(page, preview.trial);
  if (preview.kind !== "running") return "";
  if (preview.near) return trialWords(page, preview.near);
  return `A structure of ${faces} panels, not all of them flat, and ${vertices} points; planarising is being tried.`;
}

/** What the view shows of a planarising that is tried out. */
export function PreviewWords() {
  const page = usePage();
  const report = page.mesh.value?.report;
  return report ? previewWords(page, report) : null;
}

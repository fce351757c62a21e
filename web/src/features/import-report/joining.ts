// SPDX-License-Identifier: MIT
// What programs take from a mesh when they write it, given back: quads, common points, one outside.
import { isAsOpened } from "../../design/design.ts";
import type { Mending, MeshReport } from "../../solver/protocol.ts";
import { enqueue, type Outcome } from "../../state/action-queue.ts";
import { run } from "../../state/connection.ts";
import { adopt } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { keepUp } from "./up-axis.ts";

type Told = (before: MeshReport, after: MeshReport) => string;

const NO_QUADS = "No two triangles make a quad.";

/** The mesh that is open, mended: one step, like another file. */
function mend(page: Page, way: Mending, may: () => boolean, told: Told): Outcome {
  return enqueue(page, async () => {
    const { source } = page.draft.value ?? {};
    const before = page.mesh.value?.report;
    // An action queued before this one may have made it flat.
    if (source?.kind !== "file" || !before || !may()) return;
    const question = { kind: "join", name: source.name, way } as const;
    const answer = await run(page, "mending the mesh", question, "opened");
    if (!answer.ok || !answer.value.source) return answer;
    const { mesh } = answer.value;
    keepUp(page, source, answer.value.source);
    adopt(page, answer.value.source, null, mesh);
    page.importReport.value = true;
    page.notice.value = told(before, mesh.report);
    return answer;
  });
}

/** The mesh that is open, its triangles two by two as quads. */
export const joinTriangles = (page: Page): Outcome =>
  mend(
    page,
    "joinTriangles",
    () => mayHaveLostQuads(page),
    (before, after) => {
      const quads = before.faces - after.faces;
      return quads > 0 ? `${quads} quads of two triangles each.` : NO_QUADS;
    },
  );

/** The mesh that is open, with points at one place as one. */
export const joinPoints = (page: Page): Outcome =>
  mend(
    page,
    "joinPoints",
    () => warnsOf(page, "--join-points"),
    (before, after) => {
      const joined = before.vertices - after.vertices;
      return `${joined} points were joined with another one.`;
    },
  );

/** The mesh that is open, with neighbours turned to agree. */
export const turnPanels = (page: Page): Outcome =>
  mend(
    page,
    "orient",
    () => warnsOf(page, "--orient"),
    () => "Neighbouring panels agree.",
  );

/** Whether a file, as it was opened, has the fault whose warning names this option of `convert`. */
export function warnsOf(page: Page, option: "--join-points" | "--orient"): boolean {
  const design = page.draft.value;
  if (design?.source.kind !== "file" || !isAsOpened(design)) return false;
  return page.mesh.value?.report.warnings.some((warning) => warning.includes(option)) ?? false;
}

/** Whether the mesh is a file's, as it was opened, and most of its panels are triangles. */
export function mayHaveLostQuads(page: Page): boolean {
  const design = page.draft.value;
  const { faces = 0, faceSizes = {} } = page.mesh.value?.report ?? {};
  if (design?.source.kind !== "file" || !isAsOpened(design)) return false;
  return 2 * (faceSizes[3] ?? 0) > faces;
}

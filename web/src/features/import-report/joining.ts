// SPDX-License-Identifier: MIT
// The quads of a mesh that a program wrote as triangles.
import { isAsOpened } from "../../design/design.ts";
import { run } from "../../state/connection.ts";
import { adopt } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { inTurn, type Outcome } from "../../state/turns.ts";
import { keepUp } from "./up-axis.ts";

const NO_QUADS = "No two triangles make a quad.";

/** The mesh that is open, its triangles two by two as quads: one step, like another file. */
export const joinTriangles = (page: Page): Outcome =>
  inTurn(page, async () => {
    const { source } = page.draft.value ?? {};
    const before = page.mesh.value?.report.faces ?? 0;
    // A turn before this one may have made it flat.
    if (source?.kind !== "file" || !mayHaveLostQuads(page)) return;
    const question = { kind: "join", name: source.name } as const;
    const answer = await run(page, "joining triangles", question, "opened");
    if (!answer.ok || !answer.value.source) return answer;
    const { mesh } = answer.value;
    keepUp(page, source, answer.value.source);
    adopt(page, answer.value.source, null, mesh);
    page.importReport.value = true;
    const quads = before - mesh.report.faces;
    page.notice.value = quads > 0 ? `${quads} quads of two triangles each.` : NO_QUADS;
    return answer;
  });

/** Whether the mesh is a file's, as it was opened, and most of its panels are triangles. */
export function mayHaveLostQuads(page: Page): boolean {
  const design = page.draft.value;
  const { faces = 0, faceSizes = {} } = page.mesh.value?.report ?? {};
  if (design?.source.kind !== "file" || !isAsOpened(design)) return false;
  return 2 * (faceSizes[3] ?? 0) > faces;
}

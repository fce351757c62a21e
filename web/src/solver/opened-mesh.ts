// SPDX-License-Identifier: MIT
// The mesh that a session has open, as the page gets it.

import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { buffersOf, prepareDisplay } from "../mesh/display-mesh.ts";
import type { OpenedMesh } from "./protocol.ts";

export function readMesh(
  module: PlanishModule,
  session: Session,
  warnings: readonly string[],
): OpenedMesh {
  const report = session.meshReport();
  return {
    report: { ...report, warnings: [...warnings, ...report.warnings] },
    positions: session.basePositions(),
    groups: session.groups(),
    parents: session.panelParents(),
    symmetry: module.symmetryOf(session),
    ...prepareDisplay({
      display: session.displayBase(),
      offsets: session.faceOffsets(),
      vertices: session.faceVertices(),
    }),
  };
}

/** What goes over with it, not as a copy. */
export const openedBuffers = (mesh: OpenedMesh): Transferable[] =>
  [mesh.positions.buffer, mesh.parents.buffer, ...buffersOf(mesh)] as Transferable[];

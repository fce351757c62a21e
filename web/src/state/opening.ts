// SPDX-License-Identifier: MIT
// Opening samples and files, planarising what is not flat. Each is one step of the history.
import type { FileFormat, OpenedMesh, Source } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { DEFAULT_SETTINGS, type Design, NO_REPORT, NO_SHAPE } from "./design.ts";
import * as steps from "./history.ts";
import { FIRST_SAMPLE, SAMPLES } from "./samples.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import { showPresent, takeMesh } from "./showing.ts";
import {
  draft,
  hintVertex,
  history,
  importReport,
  mesh,
  notice,
  problem,
  settings,
} from "./store.ts";
import { inTurn } from "./turns.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];

/** The unedited mesh as a design. */
export function freshDesign(source: Source, planarised: boolean, opened: OpenedMesh): Design {
  const { worstGap, worstMmPerM } = opened.report;
  return {
    source,
    planarised,
    handles: [],
    settings: settings.value ?? DEFAULT_SETTINGS,
    shape: NO_SHAPE,
    report: { ...NO_REPORT, worstGap, worstMmPerM },
    variation: null,
  };
}

/** Shows what the solver has opened, as one more step of the history. */
function adopt(source: Source, planarised: boolean, opened: OpenedMesh): void {
  const design = freshDesign(source, planarised, opened);
  takeMesh(design, opened);
  notice.value = null;
  history.value = history.value ? steps.record(history.value, design) : steps.begin(design);
}

export const openSample = (name: string): Promise<void> =>
  inTurn(async () => {
    const sample = SAMPLES.find((s) => s.name === name);
    if (!sample) return;
    const source: Source = { kind: "sample", name, size: sample.size };
    const question = { kind: "open", source, planarise: false } as const;
    const answer = await run(`opening ${sample.label}`, question, "opened");
    if (answer) adopt(source, false, answer.mesh);
    else await showPresent();
  });

export const openFile = (file: File): Promise<void> =>
  inTurn(async () => {
    const { name } = file;
    const extension = name.split(".").at(-1)?.toLowerCase() ?? "";
    const format = FORMATS.find((f) => f === extension);
    if (!format) {
      problem.value = `${name} cannot be read. Use an OBJ, OFF, PLY or GLB file.`;
      return;
    }
    const question = { kind: "read", file, name, format } as const;
    const answer = await run(`reading ${name}`, question, "opened");
    if (!answer?.source) return;
    adopt(answer.source, false, answer.mesh);
    importReport.value = true;
  });

/** Within a turn. */
export async function planariseNow(): Promise<void> {
  const design = draft.value;
  if (!design) return;
  const answer = await run("making every panel flat", { kind: "planarise" }, "opened");
  if (answer) adopt(design.source, true, answer.mesh);
}

export const planarise = (): Promise<void> => inTurn(planariseNow);

/** The first visit: the painted sample becomes live, and one point asks to be dragged. */
export async function openFirst(): Promise<void> {
  await openSample(FIRST_SAMPLE.name);
  const opened = mesh.value;
  if (!opened) return;
  hintVertex.value = sensibleVertex(opened.display, opened.topology.boundary, []);
}

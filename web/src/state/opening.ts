// SPDX-License-Identifier: MIT
// Opening samples and files, planarising what is not flat.
import { batch } from "@preact/signals";
import type { FileFormat, OpenedMesh, Source } from "../solver/protocol.ts";
import { run } from "./connection.ts";
import { DEFAULT_SETTINGS, type Design, NO_REPORT, NO_SHAPE } from "./design.ts";
import { begin } from "./history.ts";
import { FIRST_SAMPLE, SAMPLES } from "./samples.ts";
import { sensibleVertex } from "./sensible-vertex.ts";
import {
  designName,
  displayMesh,
  draft,
  figures,
  hintVertex,
  history,
  importReport,
  mesh,
  notice,
  panelFigures,
  problem,
  selected,
  selectedPanel,
  settings,
} from "./store.ts";

const FORMATS: readonly FileFormat[] = ["obj", "off", "ply", "glb"];

function freshDesign(source: Source, planarised: boolean, opened: OpenedMesh): Design {
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

export const sourceName = (source: Source): string =>
  source.kind === "file"
    ? source.name
    : (SAMPLES.find((s) => s.name === source.name)?.label ?? source.name);

/** Takes over a base mesh that the worker has opened; what was shown before is gone. */
export function adoptMesh(
  source: Source,
  name: string,
  planarised: boolean,
  opened: OpenedMesh,
): void {
  const design = freshDesign(source, planarised, opened);
  batch(() => {
    mesh.value = opened;
    displayMesh.value = opened;
    history.value = begin(design);
    draft.value = design;
    figures.value = design.report;
    selected.value = null;
    selectedPanel.value = null;
    panelFigures.value = null;
    hintVertex.value = null;
    notice.value = null;
    importReport.value = false;
    designName.value = name;
  });
}

export async function openSample(name: string): Promise<void> {
  const sample = SAMPLES.find((s) => s.name === name);
  if (!sample) return;
  const source: Source = { kind: "sample", name, size: sample.size };
  const answer = await run(
    `opening ${sample.label}`,
    { kind: "open", source, planarise: false },
    "opened",
  );
  if (answer) adoptMesh(source, sample.label, false, answer.mesh);
}

export async function openFile(file: File): Promise<void> {
  const extension = file.name.split(".").at(-1)?.toLowerCase() ?? "";
  const format = FORMATS.find((f) => f === extension);
  if (!format) {
    problem.value = `${file.name} cannot be read. Use an OBJ, OFF, PLY or GLB file.`;
    return;
  }
  const bytes = new Uint8Array(await file.arrayBuffer());
  const source: Source = { kind: "file", name: file.name, format, bytes };
  const answer = await run(
    `loading ${file.name}`,
    { kind: "open", source, planarise: false },
    "opened",
  );
  if (!answer) return;
  adoptMesh(source, file.name, false, answer.mesh);
  importReport.value = true;
}

export async function planarise(): Promise<void> {
  const design = draft.value;
  if (!design) return;
  const answer = await run("making every panel flat", { kind: "planarise" }, "opened");
  if (answer) adoptMesh(design.source, designName.value, true, answer.mesh);
}

/** The first visit: the painted sample becomes live, and one point asks to be dragged. */
export async function openFirst(): Promise<void> {
  await openSample(FIRST_SAMPLE.name);
  const opened = mesh.value;
  if (!opened) return;
  hintVertex.value = sensibleVertex(opened.display, opened.topology.boundary, []);
}

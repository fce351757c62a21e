// SPDX-License-Identifier: MIT
// The page within another one: it keeps nothing, opens what its address names, and answers.
import "./embedded.css";
import { effect } from "@preact/signals";
import { openAddress } from "../app/address.ts";
import { solverIsThere } from "../state/connection.ts";
import { loadFigures } from "../state/figures.ts";
import { markOf } from "../state/marking.ts";
import { openFirst } from "../state/opening.ts";
import {
  activity,
  hintVertex,
  history,
  mesh,
  notice,
  problem,
  readOnly,
  ready,
  selectedPanel,
  selection,
} from "../state/store.ts";
import { isUnit } from "../state/units.ts";
import { answer, setLook } from "./answers.ts";
import { Host } from "./host.ts";

async function tellDesign(host: Host): Promise<void> {
  const design = history.value?.present;
  const points = mesh.value?.report.vertices ?? 0;
  const mark = design && (await markOf(design.shape));
  if (!mark || history.value?.present !== design) return;
  const { status, movedVertices: movedPoints, maxDisplacement: largestMove } = design.report;
  const { handleError } = design.report;
  const detail = { status, points, movedPoints, largestMove, handleError, hash: mark.hash };
  host.tell({ event: "design", detail });
}

/** Tells from now on what happens here. */
function follow(host: Host): void {
  let told = history.peek()?.present;
  effect(() => {
    const present = history.value?.present;
    if (present === told) return;
    told = present;
    void tellDesign(host);
  });
  effect(() => {
    const detail = { doing: activity.value?.label ?? null, problem: problem.value };
    host.tell({ event: "status", detail: { ...detail, notice: notice.value } });
  });
  effect(() => {
    host.tell({
      event: "select",
      detail: { vertices: selection.value, panel: selectedPanel.value },
    });
  });
}

/** @param asked what the element put into the address */
export async function beginEmbedded(asked: URLSearchParams): Promise<void> {
  const host = new Host(asked.get("embed") ?? "");
  const unit = asked.get("unit") ?? "";
  setLook({ readonly: asked.has("readonly"), unit: isUnit(unit) ? unit : null });
  if (!(await solverIsThere())) {
    host.tell({ event: "status", detail: { doing: null, problem: problem.value, notice: null } });
    return;
  }
  if (!(await openAddress())) {
    const said = problem.value;
    await openFirst();
    problem.value = said;
  }
  if (readOnly.value) hintVertex.value = null;
  ready.value = true;
  host.listen(answer);
  host.tell({ event: "ready", detail: { version: 1 } });
  void tellDesign(host);
  follow(host);
  void loadFigures();
}

// SPDX-License-Identifier: MIT
// The page within another one: it keeps nothing, opens what its address names, and answers.
import type { Page } from "../state/page.ts";
import "./embedded.css";
import { effect } from "@preact/signals";
import { isUnit } from "../quantity/units.ts";
import { solverIsThere } from "../state/connection.ts";
import { loadFigures } from "../state/figures.ts";
import { markOf } from "../state/marking.ts";
import { openFirst } from "../state/opening.ts";
import { say } from "../state/telling.ts";
import { answer, setLook } from "./answers.ts";
import { Host } from "./host.ts";

async function tellDesign(page: Page, host: Host): Promise<void> {
  const design = page.history.value?.present;
  const points = page.mesh.value?.report.vertices ?? 0;
  const mark = design && (await markOf(page, design.shape));
  if (!mark || page.history.value?.present !== design) return;
  const { status, movedVertices: movedPoints, maxDisplacement: largestMove } = design.report;
  const { handleError } = design.report;
  const detail = { status, points, movedPoints, largestMove, handleError, hash: mark.hash };
  host.tell({ event: "design", detail });
}

/** Tells from now on what happens here. */
function follow(page: Page, host: Host): void {
  let told = page.history.peek()?.present;
  effect(() => {
    const present = page.history.value?.present;
    if (present === told) return;
    told = present;
    void tellDesign(page, host);
  });
  effect(() => {
    const detail = { doing: page.activity.value?.label ?? null, problem: page.problem.value };
    host.tell({ event: "status", detail: { ...detail, notice: page.notice.value } });
  });
  effect(() => {
    host.tell({
      event: "select",
      detail: { vertices: page.selection.value, panel: page.selectedPanel.value },
    });
  });
}

/**
 * @param asked what the element put into the address
 * @param openAddress opens the design that the address names; false if there is none
 */
export async function beginEmbedded(
  page: Page,
  asked: URLSearchParams,
  openAddress: (page: Page) => Promise<boolean>,
): Promise<void> {
  const host = new Host(asked.get("embed") ?? "");
  const unit = asked.get("unit") ?? "";
  setLook(page, { readonly: asked.has("readonly"), unit: isUnit(unit) ? unit : null });
  if (!(await solverIsThere(page))) {
    host.tell({
      event: "status",
      detail: { doing: null, problem: page.problem.value, notice: null },
    });
    return;
  }
  if (!(await openAddress(page))) {
    const said = page.problem.value;
    await openFirst(page);
    say(page, said);
  }
  if (page.readOnly.value) page.hintVertex.value = null;
  page.ready.value = true;
  host.listen((request) => answer(page, request));
  host.tell({ event: "ready", detail: { version: 1 } });
  void tellDesign(page, host);
  follow(page, host);
  void loadFigures(page);
}

// SPDX-License-Identifier: MIT
// What selects points, and what is done with all that are selected.
import type { HandleRow } from "../../design/design.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { freePins, removeHandles, setPinned } from "../../state/editing.ts";
import type { Page } from "../../state/page.ts";
import type { AreaTool } from "../../state/page-state.ts";
import { type Command, notReady } from "../../ui/commands/command.ts";
import {
  growSelection,
  selectBoundary,
  selectedEdge,
  selectLine,
  selectOthers,
  selectRing,
  shrinkSelection,
} from "./selecting-more.ts";

const noPoints = (page: Page): string =>
  page.selection.value.length > 0 ? "" : "No point is selected.";

const noEdge = (page: Page): string =>
  selectedEdge(page) ? "" : "Select two neighbouring points first.";

/** Why the selected points cannot be moved or held. */
export const cannotEdit = (page: Page): string =>
  notReady(page) || (page.baseFlat.value ? noPoints(page) : FLAT_FIRST);

/** The handles of the selected points. */
function rowsOf(page: Page): HandleRow[] {
  const chosen = new Set(page.selection.value);
  return page.handles.value.filter(({ vertex }) => chosen.has(vertex));
}

const pinsOf = (page: Page) => rowsOf(page).filter(({ pinned }) => pinned);

const selectIn = (tool: AreaTool, label: string): Command => ({
  label,
  refusal: notReady,
  run: (page) => {
    page.areaTool.value = tool;
  },
});

export const SELECTION_COMMANDS = {
  selectBox: selectIn("box", "Select in a box"),
  selectLoop: selectIn("lasso", "Select in a loop"),
  selectBoundary: { label: "Select the boundary", name: "Boundary", run: selectBoundary },
  selectLine: {
    label: "Select the line of the mesh",
    name: "Line",
    refusal: noEdge,
    run: selectLine,
  },
  selectRing: {
    label: "Select the strip of panels",
    name: "Ring",
    refusal: noEdge,
    run: selectRing,
  },
  selectOthers: { label: "Invert the selection", name: "Invert", run: selectOthers },
  growSelection: {
    label: "Grow the selection",
    name: "Grow",
    refusal: noPoints,
    run: growSelection,
  },
  shrinkSelection: {
    label: "Shrink the selection",
    name: "Shrink",
    refusal: noPoints,
    run: shrinkSelection,
  },
  // The palette has the one that also lets go.
  pinSelected: {
    label: "Pin all selected points",
    name: "Pin",
    unlisted: true,
    refusal: (page) =>
      cannotEdit(page) ||
      (pinsOf(page).length < page.selection.value.length ? "" : "All of them are pinned."),
    run: (page) => setPinned(page, page.selection.value, true),
  },
  freeSelected: {
    label: "Free the selected points",
    name: "Free",
    refusal: (page) =>
      cannotEdit(page) || (pinsOf(page).length > 0 ? "" : "None of them is pinned."),
    run: (page) => freePins(page, page.selection.value),
  },
  removeSelected: {
    label: "Remove the handles of the selected points",
    name: "Remove",
    refusal: (page) =>
      cannotEdit(page) || (rowsOf(page).length > 0 ? "" : "None of them has a handle."),
    run: (page) => removeHandles(page, page.selection.value),
  },
} satisfies Readonly<Record<string, Command>>;

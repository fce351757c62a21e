// SPDX-License-Identifier: MIT
// The commands of parts that come after the first drag.
import { candidates } from "../../features/comparing/comparing.ts";
import { continueFromShape } from "../../features/exploring/continuing.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { addHandle, removeHandles } from "../../state/editing.ts";
import { goToTab } from "../../state/inspector.ts";
import { planarise } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { cancel } from "../../state/showing.ts";
import { type Command, notReady } from "./command.ts";
import { openDoor } from "./doors.ts";

const cannotMove = (page: Page): string =>
  notReady(page) || (page.baseFlat.value ? "" : FLAT_FIRST);

export const MORE_COMMANDS = {
  addHandle: { label: "Add handle", refusal: cannotMove, run: addHandle },
  removeHandles: {
    label: "Remove all handles",
    refusal: (page) =>
      notReady(page) || (page.handles.value.length > 0 ? "" : "There are no handles."),
    run: (page) =>
      removeHandles(
        page,
        page.handles.value.map(({ vertex }) => vertex),
      ),
  },
  planarise: {
    label: "Planarise",
    refusal: (page) =>
      notReady(page) || (page.baseFlat.value ? "Every panel of this mesh is flat." : ""),
    run: planarise,
  },
  continueFromShape: {
    label: "Continue from this shape",
    refusal: (page) => notReady(page) || (isEdited(page) ? "" : "Nothing has moved."),
    run: (page) => {
      goToTab(page, "edit");
      return continueFromShape(page);
    },
  },
  compare: {
    label: "Compare",
    refusal: (page) =>
      candidates(page).value.length > 1 ? "" : "It needs a snapshot of this mesh.",
    run: (page) => {
      goToTab(page, "explore");
      return openDoor(page, "compare");
    },
  },
  cancel: {
    label: "Cancel",
    refusal: (page) => (page.busy.value ? "" : "Nothing is running."),
    run: cancel,
  },
} satisfies Readonly<Record<string, Command>>;

const isEdited = (page: Page): boolean => page.figures.value.movedVertices > 0;

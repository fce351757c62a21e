// SPDX-License-Identifier: MIT
// The commands of parts that come after the first drag.
import { FLAT_FIRST } from "../../state/dragging.ts";
import { addHandle, removeHandles } from "../../state/editing.ts";
import { planarise } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { cancel } from "../../state/showing.ts";
import { type Command, notReady } from "./command.ts";

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
  cancel: {
    label: "Cancel",
    refusal: (page) => (page.busy.value ? "" : "Nothing is running."),
    run: cancel,
  },
} satisfies Readonly<Record<string, Command>>;

// SPDX-License-Identifier: MIT
// The views that were kept under a name.
import { MOST_VIEWS } from "../../design/companions.ts";
import { toggleNumbers } from "../../features/numbers/numbering.ts";
import { keepView, showView } from "../../features/views/named-views.ts";
import { readCamera } from "../../state/camera.ts";
import type { Page } from "../../state/page.ts";
import type { Command } from "./command.ts";

export const KEEP_VIEW: Command = {
  label: "Keep this view",
  refusal: (page) => {
    if (!readCamera(page)) return "There is no 3D view.";
    // More would be left out of links, files and what is kept for the next visit.
    return page.views.value.length < MOST_VIEWS
      ? ""
      : `${MOST_VIEWS} views are kept: delete one first.`;
  },
  run: keepView,
};

/** One for each of them, as they are now. */
export const viewCommands = (page: Page): Command[] =>
  page.views.value.map((view) => ({
    label: `View: ${view.name}`,
    run: (on) => showView(on, view),
  }));

export const NUMBERS = [
  ["panels", "Number the panels"],
  ["points", "Number the points"],
] as const;

export const NUMBER_COMMANDS: readonly Command[] = NUMBERS.map(([of, label]) => ({
  label,
  run: (page) => toggleNumbers(page, of),
}));

// SPDX-License-Identifier: MIT
// The views that were kept under a name.
import { readCamera } from "../../state/camera.ts";
import { keepView, showView } from "../../state/named-views.ts";
import type { Page } from "../../state/page.ts";
import type { Command } from "./command.ts";

export const KEEP_VIEW: Command = {
  label: "Keep this view",
  refusal: (page) => (readCamera(page) ? "" : "There is no 3D view."),
  run: keepView,
};

/** One for each of them, as they are now. */
export const viewCommands = (page: Page): Command[] =>
  page.views.value.map((view) => ({
    label: `View: ${view.name}`,
    run: (on) => showView(on, view),
  }));

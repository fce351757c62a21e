// SPDX-License-Identifier: MIT
// Where the view looked from, kept under a name to come back to. Meshes are all shown at the same size:
// a view of one serves another.
import type { NamedView } from "../../design/camera.ts";
import { MOST_VIEWS } from "../../design/companions.ts";
import { placeCamera, readCamera } from "../../state/camera.ts";
import { viewOptionsShown } from "../../state/inspector.ts";
import type { Page } from "../../state/page.ts";
import type { Command } from "../../ui/commands/command.ts";

const isTaken = (page: Page, name: string): boolean =>
  page.views.value.some((view) => view.name === name);

/** The first "View n" that is free. */
function freeName(page: Page): string {
  for (let n = 1; ; ++n) if (!isTaken(page, `View ${n}`)) return `View ${n}`;
}

export function keepView(page: Page): void {
  const camera = readCamera(page);
  if (camera) page.views.value = [...page.views.value, { name: freeName(page), camera }];
}

export function showView(page: Page, { camera }: NamedView): void {
  placeCamera(page, camera);
}

/** Stays as it is where the name is taken, or none. */
export function renameView(page: Page, view: NamedView, to: string): void {
  const name = to.trim().slice(0, 100);
  if (name === "" || isTaken(page, name)) return;
  page.views.value = page.views.value.map((one) => (one === view ? { ...one, name } : one));
}

export function deleteView(page: Page, view: NamedView): void {
  page.views.value = page.views.value.filter((one) => one !== view);
}

export const KEEP_VIEW: Command = {
  label: "Keep this view",
  refusal: (page) => {
    if (!readCamera(page)) return "There is no 3D view.";
    // Views beyond these would be left out of links, files and what is kept for the next visit.
    return page.views.value.length < MOST_VIEWS
      ? ""
      : `${MOST_VIEWS} views are kept: delete one first.`;
  },
  run: (page) => {
    keepView(page);
    viewOptionsShown(page).value = true;
  },
};

/** One for each of them, as they are now, beside the one that keeps another. */
export const viewCommands = (page: Page): Command[] => [
  KEEP_VIEW,
  ...page.views.value.map((view) => ({
    label: `View: ${view.name}`,
    run: (on: Page) => showView(on, view),
  })),
];

// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import type { Camera } from "../../web/src/design/camera.ts";
import { found } from "../../web/src/features/palette/command-palette.tsx";
import {
  deleteView,
  KEEP_VIEW,
  keepView,
  renameView,
  showView,
  viewCommands,
} from "../../web/src/features/views/named-views.ts";
import { provideCamera } from "../../web/src/state/camera.ts";
import type { Page } from "../../web/src/state/page.ts";
import { refusalOf } from "../../web/src/ui/commands/command.ts";
import { pageAlone } from "./support/page-here.ts";

const from = (x: number): Camera => ({ position: [x, -1, 2], target: [0, 0, 0] });

/** A page that looks from somewhere, with where it looks from. */
function looking(): { page: Page; view: { camera: Camera } } {
  const [page, view] = [pageAlone(), { camera: from(1) }];
  provideCamera(page, {
    read: () => view.camera,
    place: (camera) => {
      view.camera = camera;
    },
  });
  return { page, view };
}

const names = (page: Page): string[] => page.views.value.map(({ name }) => name);

it("a view is kept under a free name, and shown again", () => {
  const { page, view } = looking();
  keepView(page);
  view.camera = from(5);
  keepView(page);
  expect(names(page)).toEqual(["View 1", "View 2"]);
  const [first, second] = page.views.value;
  if (!first || !second) throw new Error("no views");
  showView(page, first);
  expect(view.camera).toEqual(from(1));
  deleteView(page, first);
  keepView(page);
  expect(names(page)).toEqual(["View 2", "View 1"]);
});

it("it is renamed, but not to what another one is called, or to nothing", () => {
  const { page } = looking();
  keepView(page);
  keepView(page);
  const rename = (to: string): void => {
    const [first] = page.views.value;
    if (first) renameView(page, first, to);
  };
  rename("  From the street ");
  rename(" ");
  rename("View 2");
  expect(names(page)).toEqual(["From the street", "View 2"]);
});

it("the palette has each of them, and keeps a view where there is one", () => {
  const { page, view } = looking();
  expect(refusalOf(pageAlone(), KEEP_VIEW)).toBe("There is no 3D view.");
  expect(refusalOf(page, KEEP_VIEW)).toBe("");
  page.views.value = Array.from({ length: 50 }, (_, k) => ({ name: `${k}`, camera: from(k) }));
  expect(refusalOf(page, KEEP_VIEW)).toBe("50 views are kept: delete one first.");
  page.views.value = [];
  KEEP_VIEW.run(page, "");
  view.camera = from(5);
  const [command] = found("view 1", viewCommands(page));
  expect(command?.label).toBe("View: View 1");
  command?.run(page, "");
  expect(view.camera).toEqual(from(1));
});

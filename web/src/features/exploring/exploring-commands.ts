// SPDX-License-Identifier: MIT
import { goToTab } from "../../state/inspector.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import { type Command, notReady } from "../../ui/commands/command.ts";

const unlessEdited = (page: Page, why: string): string =>
  notReady(page) || (page.figures.value.movedVertices > 0 ? "" : why);

export const EXPLORING_COMMANDS = {
  findVariations: {
    label: "Find variations",
    refusal: (page) => unlessEdited(page, "There is no edit to vary: move a point first."),
    run: async (page) =>
      (await fetchPart(page, () => import("./gallery.ts")))?.findVariations(page),
  },
  makeExact: {
    label: "Make exact",
    refusal: notReady,
    run: async (page) => {
      goToTab(page, "check");
      await (await fetchPart(page, () => import("./exploring.ts")))?.makeExact(page);
    },
  },
  continueFromShape: {
    label: "Continue from this shape",
    refusal: (page) => unlessEdited(page, "Nothing has moved."),
    run: async (page) => {
      goToTab(page, "edit");
      await (await fetchPart(page, () => import("./continuing.ts")))?.continueFromShape(page);
    },
  },
} satisfies Readonly<Record<string, Command>>;

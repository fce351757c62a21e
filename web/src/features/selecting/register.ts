// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { laterCommands } from "../../ui/commands/offered-commands.ts";
import { Strips } from "../../ui/places.ts";

export function register(page: Page): void {
  Strips.later(page, "SelectionStrip", () => import("./selection-strip.tsx"));
  laterCommands(page).push(async () =>
    Object.values((await import("./selection-commands.ts")).SELECTION_COMMANDS),
  );
}

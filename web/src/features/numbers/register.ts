// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { laterCommands } from "../../ui/commands/offered-commands.ts";
import { ViewSections } from "../../ui/places.ts";

export function register(page: Page): void {
  ViewSections.later(page, "NumbersSection", () => import("./numbers-section.tsx"));
  laterCommands(page).push(async () => (await import("./numbering.ts")).NUMBER_COMMANDS);
}

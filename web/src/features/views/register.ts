// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { laterCommands } from "../../ui/commands/offered-commands.ts";
import { ViewSections } from "../../ui/places.ts";

export function register(page: Page): void {
  ViewSections.later(page, "ViewsSection", () => import("./views-section.tsx"));
  laterCommands(page).push(async () => (await import("./named-views.ts")).viewCommands(page));
}

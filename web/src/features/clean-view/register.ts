// SPDX-License-Identifier: MIT
import { toggleCleanView } from "../../state/clean-view.ts";
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { ViewSections } from "../../ui/places.ts";

export function register(page: Page): void {
  ViewSections.later(page, "CleanSection", () => import("./clean-section.tsx"));
  offerCommands(page, [{ label: "Clean view", run: toggleCleanView }]);
}

// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { SECTIONS, UnderHandles } from "../../ui/places.ts";
import { EXPLORING_COMMANDS } from "./exploring-commands.ts";

export function register(page: Page): void {
  UnderHandles.later(page, "NextSteps", () => import("./explore-section.tsx"));
  SECTIONS.explore.later(page, "ExploreSection", () => import("./explore-section.tsx"));
  SECTIONS.check.later(page, "ExactSection", () => import("./exact-section.tsx"));
  offerCommands(page, Object.values(EXPLORING_COMMANDS));
}

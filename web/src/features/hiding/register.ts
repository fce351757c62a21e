// SPDX-License-Identifier: MIT
import { followers } from "../../scene/followers.ts";
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { LastTools, SelectionSight, ViewNotes } from "../../ui/places.ts";
import { HIDING_COMMANDS, HIDING_KEYS } from "./hiding-commands.ts";
import { followHiding } from "./hiding-follower.ts";

export function register(page: Page): void {
  LastTools.later(page, "SightTools", () => import("./hiding-controls.tsx"));
  SelectionSight.later(page, "SelectionSightTools", () => import("./hiding-controls.tsx"));
  ViewNotes.later(page, "HiddenNote", () => import("./hiding-controls.tsx"));
  followers(page).push(followHiding);
  offerCommands(page, Object.values(HIDING_COMMANDS), HIDING_KEYS);
}

// SPDX-License-Identifier: MIT
import { followers } from "../../scene/followers.ts";
import { goToTab, layerAsked, layerCalls } from "../../state/inspector.ts";
import type { Page } from "../../state/page.ts";
import { notReady } from "../../ui/commands/command.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { SECTIONS, ViewNotes } from "../../ui/places.ts";
import { followOffset } from "./offset-follower.ts";

function askForLayer(page: Page): void {
  goToTab(page, "check");
  layerAsked(page).value = true;
  layerCalls(page).value += 1;
}

export function register(page: Page): void {
  SECTIONS.check.later(page, "LayerSection", () => import("./layer-section.tsx"));
  ViewNotes.later(page, "LayerNote", () => import("./offset-note.tsx"));
  followers(page).push(followOffset);
  offerCommands(page, [{ label: "Second layer", refusal: notReady, run: askForLayer }]);
}

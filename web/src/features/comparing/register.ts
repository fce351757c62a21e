// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { laterCommands } from "../../ui/commands/offered-commands.ts";
import { SECTIONS } from "../../ui/places.ts";

export function register(page: Page): void {
  SECTIONS.explore.later(page, "SnapshotsSection", () => import("./snapshots-section.tsx"));
  laterCommands(page).push(async () => [(await import("./comparing.ts")).COMPARE]);
}

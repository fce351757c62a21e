// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { ClickTools, SECTIONS, Strips } from "../../ui/places.ts";
import { CUT, CutTool } from "./cut-button.tsx";

export function register(page: Page): void {
  ClickTools.put(page, CutTool);
  Strips.later(page, "CutStrips", () => import("./cut-strip.tsx"));
  SECTIONS.edit.later(page, "CutSection", () => import("./cut-section.tsx"));
  offerCommands(page, [CUT], "cuts panels by clicks in the view, until pressed again");
}

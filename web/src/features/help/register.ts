// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { BarEnd } from "../../ui/places.ts";
import { HELP, HelpDialog } from "./help-dialog.tsx";

export function register(page: Page): void {
  BarEnd.put(page, HelpDialog);
  offerCommands(page, [HELP]);
}

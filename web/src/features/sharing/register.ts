// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { offerCommands } from "../../ui/commands/offered-commands.ts";
import { BarEnd } from "../../ui/places.ts";
import { SHARE, ShareDialog } from "./share-dialog.tsx";

export function register(page: Page): void {
  BarEnd.put(page, ShareDialog);
  offerCommands(page, [SHARE]);
}

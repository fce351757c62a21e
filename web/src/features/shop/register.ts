// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { exportCommands } from "../../ui/commands/export-commands.ts";
import { BarEnd } from "../../ui/places.ts";
import { SHOP_EXPORTS, ShopDialogs } from "./shop-doors.tsx";

export function register(page: Page): void {
  BarEnd.put(page, ShopDialogs);
  exportCommands(page).push(...SHOP_EXPORTS);
}

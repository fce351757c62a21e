// SPDX-License-Identifier: MIT
import type { Browser, BrowserServer } from "playwright-core";

export function launch(how?: { readonly smooth?: boolean }): Promise<Browser>;
export function launchServer(): Promise<BrowserServer>;

// SPDX-License-Identifier: MIT
import type { Browser } from "playwright-core";

export function launch(how?: { readonly smooth?: boolean }): Promise<Browser>;

// SPDX-License-Identifier: MIT
import type { Browser } from "playwright-core";

export function launch(): Promise<Browser>;

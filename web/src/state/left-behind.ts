// SPDX-License-Identifier: MIT
// A drag whose panels did not follow in time, no limit holding them: it ended where they were.
import { signal } from "@preact/signals";
import type { Design } from "../design/design.ts";
import { kept } from "./page.ts";

/** The design that the last drag ended as, if that one; its pull is that of `lastRefusedPull`. */
export const lastLeftBehind = kept(() => signal<Design | null>(null));

// SPDX-License-Identifier: MIT
// The plane that cuts the view open. It changes nothing of the design, and is kept with it.
import { signal } from "@preact/signals";
import type { SectionPlane } from "../design/section-plane.ts";
import { kept } from "./page.ts";

/** null: nothing is cut. */
export const sectionPlane = kept(() => signal<SectionPlane | null>(null));

// SPDX-License-Identifier: MIT
import { signal } from "@preact/signals";
import type { Shape, SliderLead } from "../solver/protocol.ts";
import { kept } from "./page.ts";

/** What each slider of the family around a shape does. */
export const sliderLeads = kept(() =>
  signal<{
    readonly centre: Shape;
    readonly leads: readonly SliderLead[];
  } | null>(null),
);

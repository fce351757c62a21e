// SPDX-License-Identifier: MIT
// A note that its author hands over with a design; plain text.
import { signal } from "@preact/signals";
import { kept } from "./page.ts";

export const note = kept(() => signal(""));

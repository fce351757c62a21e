// SPDX-License-Identifier: MIT
// A tool that clicks in the view are for, in place of points and panels. Drags turn the camera meanwhile.
import { signal } from "@preact/signals";
import { kept } from "../state/page.ts";
import type { Place } from "./picking.ts";

export interface ViewTool {
  /** The mouse is here; null: it has left the view. */
  readonly hover: (at: Place | null) => void;
  /** @param coarse by a finger */
  readonly click: (at: Place, coarse: boolean) => void;
  /** Gives up what was begun, or the tool. */
  readonly escape: () => void;
}

export const viewTool = kept(() => signal<ViewTool | null>(null));

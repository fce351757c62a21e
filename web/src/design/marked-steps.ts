// SPDX-License-Identifier: MIT
import type { EditSettings, Planarising, ResultMark } from "../solver/protocol.ts";
import type { Family, HandleRow } from "./design.ts";

/** What was done to a mesh, with a mark of what came out of it. */
export interface MarkedSteps {
  readonly planarised: Planarising | null;
  readonly handles: readonly HandleRow[];
  readonly settings: EditSettings;
  /** Families of variations, each around what the one before it gave; the last has the sliders. */
  readonly families: readonly Family[];
  readonly mark: ResultMark;
}

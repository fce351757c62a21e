// SPDX-License-Identifier: MIT
import type { Design } from "../../design/design.ts";
import type { Trial } from "../../design/planarising.ts";

/** Whether every panel is as flat as was asked for. */
export const isMet = ({ how, mesh: { report } }: Trial, { settings }: Design): boolean =>
  report.worstExcess <= Math.max(settings.tolerance, how.flat);

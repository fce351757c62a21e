// SPDX-License-Identifier: MIT
import type { Design } from "../../design/design.ts";
import type { Trial } from "../../design/planarising.ts";
import { type OpenedMesh, PER_PANEL } from "../../solver/protocol.ts";
import { isFar } from "./stops.ts";

/** Whether every panel is as flat as was asked for. */
export const isMet = ({ how, mesh: { report } }: Trial, { settings }: Design): boolean =>
  report.worstExcess <= Math.max(settings.tolerance, how.flat);

/** Whether nothing else is to be shown in its place: it is met, or near the file. */
export const serves = (trial: Trial, design: Design, opened: OpenedMesh): boolean =>
  isMet(trial, design) || !isFar(trial.mesh.report.planarising.largest, opened);

/** What counts of every panel's bend, mm/m. @param figures as in PanelMeasures */
export function excessesOf(figures: Float32Array): Float32Array {
  const stride = PER_PANEL.figures;
  return figures.filter((_, k) => k % stride === stride - 1);
}

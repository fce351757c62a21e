// SPDX-License-Identifier: MIT
// The line around panels: the one that is selected, those at a limit.
import { LineOverlay } from "./line-overlay.ts";

export class PanelOutline extends LineOverlay {
  constructor() {
    // The line is drawn whole over the panels' edges, which share its place, and through what hides it.
    super({ linewidth: 3, transparent: true, depthTest: false });
  }

  /** @param panels of each x, y, z of each corner in order */
  draw(panels: readonly Float32Array[]): void {
    const lines = new Float32Array(panels.reduce((sum, corners) => sum + 2 * corners.length, 0));
    let at = 0;
    for (const corners of panels) {
      for (let k = 0; k < corners.length; k += 3, at += 6) {
        const next = (k + 3) % corners.length;
        lines.set(corners.subarray(k, k + 3), at);
        lines.set(corners.subarray(next, next + 3), at + 3);
      }
    }
    this.set(lines);
  }
}

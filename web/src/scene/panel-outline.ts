// SPDX-License-Identifier: MIT
// The line around panels: the one that is selected, those at a limit.
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

export class PanelOutline {
  readonly object = new LineSegments2(
    new LineSegmentsGeometry(),
    // Whole over the panels' edges, which share its place, and through what hides the panel.
    new LineMaterial({ linewidth: 3, transparent: true, depthTest: false }),
  );

  constructor() {
    this.object.visible = false;
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
  }

  /** Of each panel: x, y, z of each corner in order. */
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
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry().setPositions(lines);
    this.object.visible = lines.length > 0;
  }

  setColour(colour: string): void {
    this.object.material.color.set(colour);
  }

  setSize(width: number, height: number): void {
    this.object.material.resolution.set(width, height);
  }

  dispose(): void {
    this.object.geometry.dispose();
    this.object.material.dispose();
  }
}

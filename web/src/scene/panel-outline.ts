// SPDX-License-Identifier: MIT
// The line around the selected panel.
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

  /** `corners`: x, y, z of each corner in order. */
  draw(corners: Float32Array): void {
    const count = corners.length / 3;
    const lines = new Float32Array(2 * corners.length);
    for (let k = 0; k < count; ++k) {
      const next = (k + 1) % count;
      lines.set(corners.subarray(3 * k, 3 * k + 3), 6 * k);
      lines.set(corners.subarray(3 * next, 3 * next + 3), 6 * k + 3);
    }
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry().setPositions(lines);
    this.object.visible = true;
  }

  clear(): void {
    this.object.visible = false;
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

// SPDX-License-Identifier: MIT
// Lines some pixels wide over the panels' edges, all of them drawn anew when they change.
import { LineMaterial, type LineMaterialParameters } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";

export class LineOverlay {
  readonly object: LineSegments2;

  constructor(look: LineMaterialParameters) {
    this.object = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial(look));
    this.object.visible = false;
    this.object.frustumCulled = false;
    this.object.renderOrder = 1;
  }

  /** @param lines x, y, z of both ends of each, display coordinates */
  protected set(lines: Float32Array | number[]): void {
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

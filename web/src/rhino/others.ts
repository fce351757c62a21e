// SPDX-License-Identifier: MIT
// Objects of a file that are no panels: what can be drawn is context, the rest is left out, by name.
import type { GeometryBase } from "rhino3dm";
import { type Context, ContextCollector } from "./context.ts";
import type { Faces, RhinoModule } from "./model.ts";
import { ObjectCount } from "./object-count.ts";

export class Others {
  readonly #shown: ObjectCount;
  readonly #leftOut: ObjectCount;
  readonly #context: ContextCollector;

  constructor(rhino: RhinoModule) {
    this.#shown = new ObjectCount(rhino);
    this.#leftOut = new ObjectCount(rhino);
    this.#context = new ContextCollector(rhino);
  }

  #of(drawn: boolean): ObjectCount {
    return drawn ? this.#shown : this.#leftOut;
  }

  hidden(): void {
    this.#leftOut.hidden();
  }

  /** Where a mesh was read instead. */
  polyline(corners: readonly number[]): void {
    this.#of(this.#context.outline(corners)).polyline();
  }

  /** Where outlines of ours were read instead. */
  mesh(mesh: Faces): void {
    this.#of(this.#context.mesh(mesh)).mesh();
  }

  object(geometry: GeometryBase): void {
    this.#of(this.#context.object(geometry)).object(geometry);
  }

  /** What is drawn; null for nothing. */
  context(): Context | null {
    return this.#context.take();
  }

  /** Sentences. */
  remarks(): readonly string[] {
    const [shown, leftOut] = [this.#shown.words, this.#leftOut.words];
    const remarks: string[] = [];
    if (shown) remarks.push(`Shown as context, in grey: ${shown}.`);
    if (leftOut) remarks.push(`Left out: ${leftOut}.`);
    return remarks;
  }

  /** Why there is nothing to open. */
  instead(): string {
    const words = [this.#shown.words, this.#leftOut.words].filter((part) => part).join(", ");
    const held = words ? ` It holds ${words}.` : "";
    const advice =
      this.#shown.surfaces || this.#leftOut.surfaces
        ? " In Rhino, DupFaceBorder makes closed polylines of flat surfaces."
        : "";
    return `It holds no mesh and no closed polyline.${held}${advice}`;
  }
}

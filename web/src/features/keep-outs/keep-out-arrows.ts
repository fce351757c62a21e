// SPDX-License-Identifier: MIT
// Arrows that move a keep-out in the view. They get what the pointer does before the view's own tool,
// which then knows nothing of it.
import { type Group, Object3D, Vector3 } from "three";
import type { TransformControls } from "three/addons/controls/TransformControls.js";
import type { Stage } from "../../scene/stage.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";

export class KeepOutArrows {
  readonly #stage: Stage;
  readonly #body: Group;
  readonly #upOnly: boolean;
  /** Display units, when it is let go. */
  readonly #moved: (by: Vector3) => void;
  readonly #proxy = new Object3D();
  readonly #begin: Vector3;
  readonly #off = new AbortController();
  #controls: TransformControls | null = null;

  constructor(
    page: Page,
    stage: Stage,
    body: Group,
    upOnly: boolean,
    moved: (by: Vector3) => void,
  ) {
    this.#stage = stage;
    this.#body = body;
    this.#upOnly = upOnly;
    this.#moved = moved;
    this.#begin = new Vector3().setFromMatrixPosition(body.matrix);
    this.#proxy.position.copy(this.#begin);
    stage.scene.add(this.#proxy);
    void this.#fetch(page);
  }

  async #fetch(page: Page): Promise<void> {
    const fetched = await fetchPart(
      page,
      () => import("three/addons/controls/TransformControls.js"),
    );
    if (!fetched || this.#off.signal.aborted) return;
    const controls = new fetched.TransformControls(this.#stage.camera, null);
    controls.setSize(0.7);
    controls.setColors("#C2453A", "#3C8A4E", "#2F5FD0", "#F2B134");
    controls.showX = !this.#upOnly;
    controls.showY = !this.#upOnly;
    controls.attach(this.#proxy);
    this.#stage.scene.add(controls.getHelper());
    this.#stage.aids.add(controls.getHelper());
    this.#controls = controls;
    this.#listen(controls, this.#stage.renderer.domElement);
    this.#stage.invalidate();
  }

  #listen(controls: TransformControls, canvas: HTMLCanvasElement): void {
    const place = ({ clientX, clientY }: PointerEvent, button: number): PointerEvent => {
      const { left, top, width, height } = canvas.getBoundingClientRect();
      const [x, y] = [(2 * (clientX - left)) / width - 1, 1 - (2 * (clientY - top)) / height];
      // Typed as an event, but only a place in −1 … 1 and the button are read from it.
      return { x, y, button } as unknown as PointerEvent;
    };
    const on = (
      name: "pointerdown" | "pointermove" | "pointerup" | "pointercancel",
      act: (event: PointerEvent) => boolean,
    ): void =>
      canvas.parentElement?.addEventListener(
        name,
        (event) => {
          if (event.target !== canvas || !act(event)) return;
          event.stopPropagation();
          this.#stage.invalidate();
        },
        { capture: true, signal: this.#off.signal },
      );
    on("pointerdown", (event) => {
      controls.pointerHover(place(event, 0));
      if (event.button !== 0 || controls.axis === null) return false;
      canvas.setPointerCapture(event.pointerId);
      controls.pointerDown(place(event, 0));
      return true;
    });
    on("pointermove", (event) => {
      if (!controls.dragging) {
        controls.pointerHover(place(event, 0));
        this.#stage.invalidate();
        return false;
      }
      controls.pointerMove(place(event, -1));
      this.#body.position.copy(this.#proxy.position);
      return true;
    });
    on("pointerup", (event) => this.#lift(controls, place(event, 0), true));
    on("pointercancel", (event) => this.#lift(controls, place(event, 0), false));
  }

  #lift(controls: TransformControls, at: PointerEvent, keep: boolean): boolean {
    if (!controls.dragging) return false;
    controls.pointerUp(at);
    const by = this.#proxy.position.clone().sub(this.#begin);
    if (keep && by.length() > 0) this.#moved(by);
    else {
      this.#proxy.position.copy(this.#begin);
      this.#body.position.copy(this.#begin);
    }
    return true;
  }

  dispose(): void {
    this.#off.abort();
    const helper = this.#controls?.getHelper();
    this.#controls?.detach();
    if (helper) this.#stage.aids.delete(helper);
    helper?.removeFromParent();
    helper?.dispose();
    this.#proxy.removeFromParent();
  }
}

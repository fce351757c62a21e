// SPDX-License-Identifier: MIT
import { useEffect, useRef } from "preact/hooks";
import { drawPatch, type Patch } from "../../scene/patch-drawing.ts";
import type { OpenedMesh, Shape } from "../../solver/protocol.ts";

/** CSS pixels where there is room; elsewhere it is shown smaller. */
const SIZE = [136, 102] as const;

interface PatchPictureProps {
  readonly mesh: OpenedMesh;
  readonly patch: Patch;
  readonly shape: Shape;
}

/** Decoration: what it shows is said in words beside it. */
export function PatchPicture({ mesh, patch, shape }: PatchPictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const draw = (): void => {
      if (canvas.current) drawPatch(canvas.current, mesh, patch, shape, SIZE);
    };
    draw();
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", draw);
    return () => dark.removeEventListener("change", draw);
  }, [mesh, patch, shape]);
  return (
    <span aria-hidden="true">
      <canvas ref={canvas} class="picture" />
    </span>
  );
}

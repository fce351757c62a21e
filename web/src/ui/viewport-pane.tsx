// SPDX-License-Identifier: MIT
import { useEffect, useRef } from "preact/hooks";
import { providePicture } from "../export/exporting.ts";
import type { ViewName } from "../scene/framing.ts";
import { Viewport } from "../scene/viewport.ts";
import { provideCamera } from "../state/camera.ts";
import { figures, mesh, problem } from "../state/store.ts";
import { DragTools } from "./drag-tools.tsx";
import { Legend } from "./legend.tsx";
import { PanelFigure } from "./panel-figure.tsx";
import { ViewKeys } from "./view-keys.ts";

const VIEWS: readonly (readonly [ViewName, string])[] = [
  ["Perspective", "1"],
  ["Top", "2"],
  ["Front", "3"],
  ["Side", "4"],
];

function Summary() {
  const report = mesh.value?.report;
  return (
    <p id="view-summary" class="visually-hidden">
      {report
        ? `A structure of ${report.faces} flat panels and ${report.vertices} points; ${figures.value.movedVertices} points moved. Arrow keys step from point to point.`
        : "The model is being prepared."}
    </p>
  );
}

/** A word that gives way to a shorter one where there is little room. */
function Shortened({ long, short }: { long: string; short: string }) {
  return (
    <>
      <span class="long-word">{long}</span>
      <span class="short-word" aria-hidden="true">
        {short}
      </span>
    </>
  );
}

/** Nothing of the page works without WebGL; say so instead of leaving a hole. */
function mount(parts: ConstructorParameters<typeof Viewport>[0]): Viewport | null {
  try {
    return new Viewport(parts);
  } catch {
    problem.value = "This browser cannot show 3D (WebGL is off). Everything else still works.";
    return null;
  }
}

export function ViewportPane() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const markers = useRef<HTMLDivElement>(null);
  const hint = useRef<HTMLDivElement>(null);
  const figure = useRef<HTMLDivElement>(null);
  const box = useRef<HTMLDivElement>(null);
  const viewport = useRef<Viewport | null>(null);
  useEffect(() => {
    if (!canvas.current || !markers.current || !hint.current || !figure.current || !box.current)
      return;
    const view = mount({
      canvas: canvas.current,
      markers: markers.current,
      hint: hint.current,
      figure: figure.current,
      box: box.current,
    });
    viewport.current = view;
    if (!view) return;
    const keys = new ViewKeys(canvas.current, view);
    providePicture(() => view.picture());
    provideCamera(view.stage);
    return () => {
      providePicture(null);
      provideCamera(null);
      keys.dispose();
      view.dispose();
    };
  }, []);
  return (
    <div class="viewport">
      {/* biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: it takes keys of its own */}
      <canvas
        ref={canvas}
        class="canvas"
        role="application"
        tabIndex={0}
        aria-label="3D view"
        aria-describedby="view-summary"
      />
      <Summary />
      <div ref={markers} class="markers" aria-hidden="true" />
      <div ref={hint} class="hint" hidden>
        <span>Drag this point. Every panel stays flat.</span>
      </div>
      <div ref={figure} class="panel-figure" hidden>
        <PanelFigure />
      </div>
      <div ref={box} class="selection-box" hidden />
      <DragTools />
      <Legend />
      <fieldset class="views">
        <legend class="visually-hidden">Views</legend>
        <button type="button" title="Fit (F)" onClick={() => viewport.current?.fit()}>
          Fit
        </button>
        {VIEWS.map(([name, key]) => (
          <button
            key={name}
            type="button"
            title={`${name} (${key})`}
            onClick={() => viewport.current?.view(name)}
          >
            {name === "Perspective" ? <Shortened long={name} short="3D" /> : name}
          </button>
        ))}
      </fieldset>
    </div>
  );
}

// SPDX-License-Identifier: MIT
import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import type { ViewName } from "../scene/framing.ts";
import { Viewport, type ViewportParts } from "../scene/viewport.ts";
import { provideCamera } from "../state/camera.ts";
import { isFlat } from "../state/flatness.ts";
import { figures, mesh, offsetChoice, problem, showBefore, takePicture } from "../state/store.ts";
import { DragTools } from "./drag-tools.tsx";
import { later } from "./later.tsx";
import { Legend } from "./legend.tsx";
import { ViewKeys } from "./view-keys.ts";

const PanelFigure = later(() => import("./panel-figure.tsx").then((part) => part.PanelFigure));
const Announcement = later(() => import("./announcement.tsx").then((part) => part.Announcement));
const OffsetNote = later(() => import("./offset-note.tsx").then((part) => part.OffsetNote));
const PointFigure = later(() => import("./point-figure.tsx").then((part) => part.PointFigure));

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
        ? `A structure of ${report.faces} ${isFlat(figures.value) ? "flat panels" : "panels, not all of them flat,"} and ${report.vertices} points; ${figures.value.movedVertices} points moved. Arrow keys step from point to point.`
        : "The model is being prepared."}
    </p>
  );
}

/** What is seen while B or Before is held. */
function BeforeNote() {
  return showBefore.value ? <div class="before-note">Before the edit</div> : null;
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

type PartRefs = { readonly [K in keyof ViewportParts]: RefObject<ViewportParts[K] | null> };

/** null unless all of them are there. */
function partsOf(refs: PartRefs): ViewportParts | null {
  const found = Object.entries(refs).map(([name, { current }]) => [name, current] as const);
  if (found.some(([, element]) => !element)) return null;
  return Object.fromEntries(found) as unknown as ViewportParts;
}

/** Nothing of the page works without WebGL; say so instead of leaving a hole. */
function mount(parts: ViewportParts): Viewport | null {
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
  const pulls = useRef<HTMLDivElement>(null);
  const hint = useRef<HTMLDivElement>(null);
  const figure = useRef<HTMLDivElement>(null);
  const point = useRef<HTMLDivElement>(null);
  const knob = useRef<HTMLDivElement>(null);
  const box = useRef<HTMLDivElement>(null);
  const legend = useRef<HTMLFieldSetElement>(null);
  const views = useRef<HTMLFieldSetElement>(null);
  const viewport = useRef<Viewport | null>(null);
  useEffect(() => {
    const parts = partsOf({
      canvas,
      markers,
      pulls,
      hint,
      figure,
      point,
      box,
      legend,
      views,
      knob,
    });
    const view = parts && mount(parts);
    viewport.current = view;
    if (!parts || !view) return;
    const keys = new ViewKeys(parts.canvas, view);
    takePicture.value = () => view.picture();
    provideCamera(view.stage);
    return () => {
      takePicture.value = null;
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
      <Announcement />
      <div ref={pulls} class="markers" aria-hidden="true" />
      <div ref={markers} class="markers" aria-hidden="true" />
      <div ref={hint} class="hint" hidden>
        <span>Drag this point. Every panel stays flat.</span>
      </div>
      <div ref={figure} class="panel-figure" hidden>
        <PanelFigure />
      </div>
      <div ref={point} class="point-figure" hidden>
        <PointFigure />
      </div>
      <div ref={knob} class="reach-knob" title="Drag: how far the edit reaches" hidden />
      <div ref={box} class="selection-box" hidden />
      <BeforeNote />
      {offsetChoice.value && <OffsetNote />}
      <DragTools />
      <Legend element={legend} />
      <fieldset ref={views} class="views">
        <legend class="visually-hidden">Views</legend>
        <button type="button" title="Fit all (Shift F)" onClick={() => viewport.current?.fit(true)}>
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

// SPDX-License-Identifier: MIT

import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { isFlat } from "../design/flatness.ts";
import { Viewport, type ViewportParts } from "../scene/viewport.ts";
import type { MeshReport } from "../solver/protocol.ts";
import { provideCamera, provideSight } from "../state/camera.ts";
import type { Page } from "../state/page.ts";
import { say } from "../state/telling.ts";
import { titleOf } from "./commands/command.ts";
import { COMMANDS } from "./commands/commands.ts";
import { DragTools } from "./drag-tools.tsx";
import { later } from "./later.tsx";
import { Legend } from "./legend.tsx";
import { usePage } from "./page-context.ts";
import { PanelFigures, PreviewWords, ViewNotes } from "./places.ts";
import { ViewOptions } from "./view-options.tsx";
import { offerView } from "./view-slot.ts";

const Announcement = later(() => import("./announcement.tsx").then((part) => part.Announcement));

const PointFigure = later(() => import("./point-figure.tsx").then((part) => part.PointFigure));

const VIEWS = [COMMANDS.perspective, COMMANDS.top, COMMANDS.front, COMMANDS.side] as const;

/** The words that sum up the design; a preview has words of its own. */
function summaryWords(page: Page, { faces, vertices }: MeshReport): string {
  const panels = isFlat(page.figures.value) ? "flat panels" : "panels, not all of them flat,";
  const { movedVertices } = page.figures.value;
  return `A structure of ${faces} ${panels} and ${vertices} points; ${movedVertices} points moved.`;
}

function Summary() {
  const page = usePage();
  const report = page.mesh.value?.report;
  const { kind } = page.planariseTrial.value;
  const preview = kind === "shown" || kind === "running";
  return (
    <p id="view-summary" class="visually-hidden">
      {report ? (
        <>
          {preview ? <PreviewWords /> : summaryWords(page, report)} Arrow keys step from point to
          point.
        </>
      ) : (
        "The model is being prepared."
      )}
    </p>
  );
}

/** What is seen while B or Before is held. */
function BeforeNote() {
  const page = usePage();
  if (!page.showBefore.value) return null;
  const { kind } = page.planariseTrial.value;
  return (
    <div class="before-note">
      {kind === "shown" || kind === "running" ? "As in the file" : "Before the edit"}
    </div>
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

type PartRefs = { readonly [K in keyof ViewportParts]: RefObject<ViewportParts[K] | null> };

/** null unless all of them are there. */
function partsOf(refs: PartRefs): ViewportParts | null {
  const found = Object.entries(refs).map(([name, { current }]) => [name, current] as const);
  if (found.some(([, element]) => !element)) return null;
  return Object.fromEntries(found) as unknown as ViewportParts;
}

/** Nothing of the page works without WebGL; say so instead of leaving a hole. */
function mount(page: Page, parts: ViewportParts): Viewport | null {
  try {
    return new Viewport(page, parts);
  } catch {
    say(page, "This browser cannot show 3D (WebGL is off). Everything else still works.");
    return null;
  }
}

export function ViewportPane() {
  const page = usePage();
  const canvas = useRef<HTMLCanvasElement>(null);
  const markers = useRef<HTMLDivElement>(null);
  const pulls = useRef<HTMLDivElement>(null);
  const hint = useRef<HTMLDivElement>(null);
  const figure = useRef<HTMLDivElement>(null);
  const point = useRef<HTMLDivElement>(null);
  const knob = useRef<HTMLDivElement>(null);
  const area = useRef<HTMLDivElement>(null);
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
      area,
      legend,
      views,
      knob,
    });
    const view = parts && mount(page, parts);
    viewport.current = view;
    if (!parts || !view) return;
    const leave = offerView(page, parts.canvas, view);
    page.takePicture.value = () => view.picture();
    provideCamera(page, view.stage);
    provideSight(page, (vertex) => view.sight.sees(vertex));
    return () => {
      page.takePicture.value = null;
      provideCamera(page, null);
      provideSight(page, null);
      leave();
      view.dispose();
    };
  }, []);
  return (
    <div class="viewport">
      {/* biome-ignore lint/a11y/noInteractiveElementToNoninteractiveRole: it takes keys of its own */}
      <canvas
        ref={canvas}
        id="view"
        class="canvas"
        role="application"
        tabIndex={0}
        aria-label="3D view"
        aria-describedby="view-summary"
      />
      <Summary />
      <div ref={pulls} class="markers" aria-hidden="true" />
      <div ref={markers} class="markers" aria-hidden="true" />
      <div ref={hint} class="hint" hidden>
        <span>Drag this point. Every panel stays flat.</span>
      </div>
      <div ref={figure} class="panel-figure" hidden>
        <PanelFigures />
      </div>
      <div ref={point} class="point-figure" hidden>
        <PointFigure />
      </div>
      <div ref={knob} class="reach-knob" title="Drag: how far the edit reaches" hidden />
      <div ref={area} class="selection-area" hidden>
        <svg aria-hidden="true">
          <polygon />
        </svg>
      </div>
      <BeforeNote />
      <Announcement />
      <ViewNotes />
      <DragTools />
      <Legend element={legend} />
      <fieldset ref={views} class="views">
        <legend class="visually-hidden">Views</legend>
        <button
          type="button"
          title={titleOf(page, COMMANDS.fitAll)}
          onClick={() => COMMANDS.fitAll.run(page, "")}
        >
          Fit
        </button>
        {VIEWS.map((view) => (
          <button
            key={view.label}
            type="button"
            title={titleOf(page, view)}
            onClick={() => view.run(page, "")}
          >
            {view === COMMANDS.perspective ? (
              <Shortened long={view.label} short="3D" />
            ) : (
              view.label
            )}
          </button>
        ))}
      </fieldset>
      <ViewOptions />
    </div>
  );
}

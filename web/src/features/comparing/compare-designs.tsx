// SPDX-License-Identifier: MIT
// Two to four designs side by side or swiped, by one camera, with what tells them apart.
import { usePage } from "../../ui/page-context.ts";
import "./compare.css";
import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import { formatLength } from "../../quantity/units.ts";
import { DARK, LIGHT } from "../../scene/palette.ts";
import { cssGradient } from "../../scene/ramp.ts";
import { readCamera } from "../../state/camera.ts";
import { formatDegrees } from "../../state/fold.ts";
import { adoptSnapshot } from "../../state/snapshots.ts";
import { typeWords } from "../../state/type-counts.ts";
import { CompareView, linkViews } from "./compare-view.ts";
import {
  type Candidate,
  candidates,
  chosen,
  compared,
  comparedFigures,
  type Figures,
  followCompared,
  toggleChosen,
} from "./comparing.ts";

type Layout = "side" | "swipe";

type Against = "first" | "mesh";

interface ViewsProps {
  readonly shown: readonly Candidate[];
  readonly against: Against;
  readonly layout: Layout;
  /** Share of the width that the first design keeps. */
  readonly split: number;
  /** The displacement at the ramp's end, model units. */
  readonly onScale: (largest: number) => void;
}

function Views({ shown, against, layout, split, onScale }: ViewsProps) {
  const page = usePage();
  const frame = useRef<HTMLDivElement>(null);
  const views = useRef<readonly CompareView[]>([]);
  const opened = page.mesh.value;
  useEffect(() => {
    const canvases = [...(frame.current?.querySelectorAll("canvas") ?? [])];
    const made = canvases.map((canvas) => new CompareView(canvas));
    const camera = views.current[0]?.read() ?? readCamera(page);
    views.current = made;
    linkViews(made);
    for (const view of made) if (camera) view.place(camera);
    return () => {
      for (const view of made) view.dispose();
    };
  }, [shown.length]);
  useEffect(() => {
    if (!opened) return;
    const [first] = shown;
    const reference = against === "first" && first ? first.design.shape : null;
    views.current.forEach((view, k) => {
      const design = shown[k]?.design;
      if (design) view.show(opened, design.shape, reference);
    });
    const largest = Math.max(0, ...views.current.map((view) => view.largest));
    for (const view of views.current) view.scaleTo(largest);
    onScale(largest / opened.report.scale);
  }, [shown, against, opened, onScale]);
  return (
    <div ref={frame} class={`compare-views ${layout}`} style={{ "--split": `${100 * split}%` }}>
      {shown.map(({ id, name }) => (
        <figure key={id} class="compare-view">
          <canvas aria-label={`3D view of ${name}`} role="img" />
          <figcaption>{name}</figcaption>
        </figure>
      ))}
    </div>
  );
}

/** The dialog closes with it. */
function AdoptButton({ id, name }: Pick<Candidate, "id" | "name">) {
  const page = usePage();
  return (
    <button
      type="button"
      class="button small"
      aria-label={`Adopt ${name}`}
      disabled={!page.ready.value}
      onClick={({ currentTarget }) => {
        currentTarget.closest("dialog")?.close();
        void adoptSnapshot(page, id);
      }}
    >
      Adopt
    </button>
  );
}

type Words = (
  figures: Figures,
  length: (model: number | null) => string,
  first: Figures | undefined,
) => string;

const typesIn = ({ types }: Figures): string =>
  types === undefined ? "…" : types ? typeWords(types) : "–";

/** None where the first design's is by another operator. */
const bendIn: Words = ({ bend, fairness }, length, first) =>
  length(first && first.fairness !== fairness ? null : bend);

const COLUMNS: readonly (readonly [string, Words])[] = [
  ["Points moved", ({ moved }) => String(moved)],
  ["Must be made again", ({ changed }) => String(changed)],
  ["Spoilt", ({ spoilt }) => String(spoilt)],
  ["Sharpest fold", ({ fold }) => formatDegrees(fold)],
  ["Smallest angle", ({ angle }) => formatDegrees(angle)],
  ["Largest panel", ({ area }) => `${area.toPrecision(3)} m²`],
  ["Largest slide", ({ slide }, length) => length(slide)],
  ["Handle from its target", ({ short }, length) => length(short)],
  ["Largest bend", bendIn],
  ["Types", typesIn],
];

function Table({ shown }: { shown: readonly Candidate[] }) {
  const page = usePage();
  const length = (model: number | null): string =>
    model === null ? "–" : formatLength(model, page.unit.value);
  const all = comparedFigures(page).value;
  const first = all.get(shown[0]?.id ?? "");
  return (
    <div class="compare-figures">
      <table class="compare-table" aria-label="Comparison">
        <thead>
          <tr>
            <th scope="col">Design</th>
            {COLUMNS.map(([title]) => (
              <th key={title} scope="col">
                {title}
              </th>
            ))}
            <td />
          </tr>
        </thead>
        <tbody>
          {shown.map(({ id, name }) => {
            const figures = all.get(id);
            return (
              <tr key={id}>
                <th scope="row">{name}</th>
                {COLUMNS.map(([title, words]) => (
                  <td key={title}>{figures ? words(figures, length, first) : "…"}</td>
                ))}
                <td>{id !== "" && <AdoptButton id={id} name={name} />}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

function Choice() {
  const page = usePage();
  return (
    <fieldset class="compare-choice">
      <legend class="visually-hidden">Designs to compare, two to four</legend>
      {candidates(page).value.map(({ id, name }) => (
        <label key={id} class="check">
          <input
            type="checkbox"
            checked={chosen(page).value.includes(id)}
            onChange={({ currentTarget }) => {
              toggleChosen(page, id);
              currentTarget.checked = chosen(page).value.includes(id);
            }}
          />
          <span>{name}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** Everything in the dialog Compare. */
export function CompareDesigns() {
  const page = usePage();
  const layout = useSignal<Layout>("side");
  const against = useSignal<Against>("first");
  const split = useSignal(0.5);
  const scale = useSignal(0);
  const setScale = useRef((largest: number) => {
    scale.value = largest;
  });
  useEffect(() => followCompared(page), [page]);
  const shown = layout.value === "swipe" ? compared(page).value.slice(0, 2) : compared(page).value;
  const shownKey = useRef<readonly Candidate[]>([]);
  const same =
    shown.length === shownKey.current.length &&
    shown.every((one, k) => one === shownKey.current[k]);
  if (!same) shownKey.current = shown;
  const words = against.value === "first" ? `from ${shown[0]?.name ?? ""}` : "from the mesh";
  return (
    <>
      <div class="compare-tools">
        <Choice />
        <label>
          <span class="legend-word">Layout</span>
          <select
            class="select"
            value={layout.value}
            onChange={({ currentTarget }) => {
              layout.value = currentTarget.value === "swipe" ? "swipe" : "side";
            }}
          >
            <option value="side">Side by side</option>
            <option value="swipe">Swipe</option>
          </select>
        </label>
        <label>
          <span class="legend-word">Colours</span>
          <select
            class="select"
            value={against.value}
            onChange={({ currentTarget }) => {
              against.value = currentTarget.value === "mesh" ? "mesh" : "first";
            }}
          >
            <option value="first">Difference from the first</option>
            <option value="mesh">Moved from the mesh</option>
          </select>
        </label>
      </div>
      <Views
        shown={shownKey.current}
        against={against.value}
        layout={layout.value}
        split={split.value}
        onScale={setScale.current}
      />
      {layout.value === "swipe" && (
        <input
          type="range"
          class="compare-swipe"
          aria-label="Swipe"
          min={0}
          max={1}
          step={0.01}
          value={split.value}
          onInput={({ currentTarget }) => {
            split.value = currentTarget.valueAsNumber;
          }}
        />
      )}
      <div class="compare-legend">
        <span>{`0 mm ${words}`}</span>
        <span
          class="legend-bar light-only"
          style={{ backgroundImage: cssGradient(LIGHT.displacement) }}
        />
        <span
          class="legend-bar dark-only"
          style={{ backgroundImage: cssGradient(DARK.displacement) }}
        />
        <span>{formatLength(scale.value, page.unit.value)}</span>
      </div>
      <Table shown={shownKey.current} />
    </>
  );
}

// SPDX-License-Identifier: MIT
// How an opened mesh becomes flat, shown on the model before it is done: close to what was opened, or
// fair.
import "./planarise-step.css";
import { useEffect, useMemo } from "preact/hooks";
import type { OpenedMesh } from "../solver/protocol.ts";
import { decimal, flatnessWords } from "../state/flatness.ts";
import { formatDegrees } from "../state/fold.ts";
import { spoiltWords, usualFold } from "../state/planarise-figures.ts";
import { EAGER_POINTS, PlanarisePreview, type Preview } from "../state/planarise-preview.ts";
import type { Trial } from "../state/planarise-trial.ts";
import {
  draft,
  mesh,
  panelFolds,
  planarising,
  ready,
  settings,
  showBefore,
  unit,
} from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { Slider } from "./slider.tsx";

/** Weights of fairness, from the nearest flat mesh to the fairest. */
const STOPS = [0, 1, 10, 100, 1000] as const;
const NAMES = ["nearest", "close", "fair", "fairer", "fairest"] as const;

/** The stop for a weight that may have come from elsewhere. */
const stopOf = (smooth: number): number => {
  const next = STOPS.findIndex((weight) => weight >= smooth);
  return next < 0 ? STOPS.length - 1 : next;
};

/** A panel of boundary points alone cannot become flat while they stay. */
function canKeepBoundary({ offsets, vertices, topology }: OpenedMesh): boolean {
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const corners = vertices.subarray(offsets[f], offsets[f + 1]);
    if (corners.length > 3 && corners.every((v) => topology.boundary[v] === 1)) return false;
  }
  return true;
}

const degrees = (fold: number | null): string => (fold === null ? "" : formatDegrees(fold));

function Figures({ trial, opened }: { trial: Trial; opened: OpenedMesh }) {
  const worst = ({ report }: OpenedMesh): string => {
    const { worstGap, worstMmPerM, worstExcess } = report;
    const { cell } = flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value);
    return cell === "flat" ? cell : `${cell} mm/m`;
  };
  const { moved, largest } = trial.mesh.report.planarising;
  const folds = [panelFolds.value, trial.measures?.folds ?? null].map((all) =>
    degrees(all && usualFold(all)),
  );
  const rows: readonly (readonly [string, string, string])[] = [
    ["Worst panel", worst(opened), worst(trial.mesh)],
    ["95 % of panels fold up to", folds[0] ?? "", folds[1] ?? ""],
    ["Newly spoilt", "", spoiltWords(trial)],
    ["Largest move", "", formatLength(largest, unit.value)],
    ["Points that move", "", `${moved} of ${opened.report.vertices}`],
  ];
  return (
    <table class="planarise-figures">
      <caption class="visually-hidden">Before and after planarising</caption>
      <thead>
        <tr>
          <td />
          <th scope="col">File</th>
          <th scope="col">After</th>
        </tr>
      </thead>
      <tbody>
        {rows.map(([name, before, after]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            <td>{before}</td>
            <td>{after}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** What else there is where panels stay bent. */
function ways(keepBoundary: boolean): string {
  const boundary = keepBoundary ? " Let the boundary move, or try" : " Try";
  return `${boundary} another place between close and fair.`;
}

function Outcome({ preview, opened }: { preview: Preview; opened: OpenedMesh }) {
  const { keepBoundary } = planarising.value;
  switch (preview.kind) {
    case "none":
      return <p class="quiet small">Move the slider to see on the model what it gives.</p>;
    case "running":
      return <p class="quiet small">Trying it on the model…</p>;
    case "refused":
      return <p class="note warn">{preview.sentence + ways(keepBoundary)}</p>;
    case "shown": {
      const { worstExcess, worstMmPerM } = preview.trial.mesh.report;
      const short = worstExcess > (settings.value?.tolerance ?? 0);
      return (
        <>
          <Figures trial={preview.trial} opened={opened} />
          {short && (
            <p class="note warn">
              {`Some panels stay up to ${decimal(worstMmPerM)} mm/m out of flat, or would lose their shape.${ways(keepBoundary)}`}
            </p>
          )}
        </>
      );
    }
  }
}

function hold(on: boolean): void {
  showBefore.value = on;
}

function HoldFile() {
  return (
    <button
      type="button"
      class="button small"
      aria-pressed={showBefore.value}
      title="Hold to see the file as it is (B)"
      onPointerDown={() => hold(true)}
      onPointerUp={() => hold(false)}
      onPointerLeave={() => hold(false)}
      onKeyDown={(event) => event.key === " " && hold(true)}
      onKeyUp={() => hold(false)}
      onBlur={() => hold(false)}
    >
      Before: the file
    </button>
  );
}

/** @param live whether it begins by itself */
export function PlanariseStep({ live }: { live: boolean }) {
  const [opened, design] = [mesh.value, draft.value];
  const preview = useMemo(
    () => (opened && design ? new PlanarisePreview(opened, design) : null),
    [opened, design],
  );
  const show = async (): Promise<boolean | null> => {
    const { keepShape = true, constraints = [] } = settings.peek() ?? {};
    return preview?.show({ ...planarising.peek(), keepShape, constraints }) ?? null;
  };
  const keep = (keepBoundary: boolean): void => {
    planarising.value = { ...planarising.peek(), keepBoundary };
  };
  /** With the boundary where it is, unless that leaves panels bent. */
  const begin = async (): Promise<void> => {
    if ((await show()) !== false || !planarising.peek().keepBoundary) return;
    keep(false);
    await show();
  };
  useEffect(() => {
    if (!opened || !preview) return;
    if (live) keep(canKeepBoundary(opened));
    if (live && opened.report.vertices <= EAGER_POINTS) void begin();
    return () => preview.end();
  }, [opened, preview, live]);
  if (!opened || !preview) return null;
  const { smooth, keepBoundary } = planarising.value;
  const stop = stopOf(smooth);
  const name = NAMES[stop] ?? "";
  const choose = (place: number): void => {
    const chosen = STOPS[place] ?? 0;
    if (chosen === planarising.peek().smooth && preview.state.peek().kind !== "none") return;
    planarising.value = { ...planarising.peek(), smooth: chosen };
    void show();
  };
  return (
    <>
      <Slider
        label="Close or fair"
        value={stop}
        min={0}
        max={STOPS.length - 1}
        step={1}
        shown={name}
        spoken={name}
        disabled={!ready.value}
        ends={["close to the file", "fair folds"]}
        onInput={choose}
        onCommit={choose}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={keepBoundary}
          onChange={({ currentTarget }) => {
            keep(currentTarget.checked);
            void show();
          }}
        />
        <span>Keep the boundary where it is</span>
      </label>
      <Outcome preview={preview.state.value} opened={opened} />
      {preview.state.value.kind === "shown" && <HoldFile />}
    </>
  );
}

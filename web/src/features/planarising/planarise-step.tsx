// SPDX-License-Identifier: MIT
// How an opened mesh becomes flat, shown on the model before it is done: close to what was opened, or
// fair.
import { signal } from "@preact/signals";
import { kept, type Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import "./planarising.css";
import { useEffect, useMemo } from "preact/hooks";
import { decimal, flatnessWords } from "../../design/flatness.ts";
import type { Preview, Trial } from "../../design/planarising.ts";
import { formatLength, unitWord } from "../../quantity/units.ts";
import type { OpenedMesh, Planarising } from "../../solver/protocol.ts";
import { formatDegrees } from "../../state/fold.ts";
import { Choice } from "../../ui/choice.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { Slider } from "../../ui/slider.tsx";
import { viewOf } from "../../ui/view-slot.ts";
import {
  EAGER_POINTS,
  isMet,
  PlanarisePreview,
  spoiltWords,
  usualFold,
} from "./planarise-preview.ts";
import { followSplitLines } from "./split-lines.ts";

/** Weights of fairness, from the nearest flat mesh to the fairest. */
const STOPS = [0, 1, 10, 100, 1000] as const;

const NAMES = ["nearest", "close", "fair", "fairer", "fairest"] as const;

/** mm/m that panels may stay out of flat; the last is the most that edits can live with. */
const FLATNESSES = [0, 1, 5, 20] as const;

const MOST_BENT = 20;

/** Of all panels, that may be split where no flat mesh is near; percent. */
const SPLITS = [0, 5, 10, 25, 50] as const;

const SPLIT_CHOICES = SPLITS.map(
  (share) => [String(share), share > 0 ? `at most ${share} %` : "none"] as const,
);

const splitShare = kept(() => signal(0));

const FLATNESS_CHOICES = FLATNESSES.map(
  (flat) => [String(flat), flat > 0 ? `to within ${flat} mm/m` : "exactly"] as const,
);

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

const splitRow = ({ split }: Trial, { report }: OpenedMesh) =>
  split ? ([["Panels split", "", `${split.panels} of ${report.faces}`]] as const) : [];

function Figures({ trial, opened }: { trial: Trial; opened: OpenedMesh }) {
  const page = usePage();
  const worst = ({ report }: OpenedMesh): string => {
    const { worstGap, worstMmPerM, worstExcess } = report;
    const { cell } = flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value);
    return cell === "flat" ? cell : `${cell} mm/m`;
  };
  const { moved, largest } = trial.mesh.report.planarising;
  const folds = [page.panelFolds.value, trial.measures?.folds ?? null].map((all) =>
    degrees(all && usualFold(all)),
  );
  const rows: readonly (readonly [string, string, string])[] = [
    ["Worst panel", worst(opened), worst(trial.mesh)],
    ["95 % of panels fold up to", folds[0] ?? "", folds[1] ?? ""],
    ["Panels it spoils", "", spoiltWords(trial)],
    ["Largest move", "", formatLength(largest, page.unit.value)],
    ["Points that move", "", `${moved} of ${opened.report.vertices}`],
    ...splitRow(trial, opened),
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
function ways({ keepBoundary, within }: Planarising): string {
  const others = [
    ...(within > 0 ? ["let points move farther"] : []),
    ...(keepBoundary ? ["let the boundary move"] : []),
    "try another place between close and fair",
  ];
  const sentence = `${others.join(", or ")}.`;
  return ` ${sentence[0]?.toUpperCase()}${sentence.slice(1)}`;
}

/** Why a trial is not as flat as was asked for, and what there is instead. */
function Short({ trial: { how, mesh }, onTry }: { trial: Trial; onTry: (flat: number) => void }) {
  const bent = decimal(mesh.report.worstMmPerM);
  const asked = how.flat > 0 ? `flat to ${how.flat} mm/m` : "exactly flat";
  const because = how.within > 0 ? "no point may move farther, and panels keep" : "they would lose";
  return (
    <div class="note warn">
      <p>
        {`Not every panel can be ${asked}: the worst stays ${bent} mm/m out of flat, because ${because} their shape.${ways(how)}`}
      </p>
      {how.flat < MOST_BENT && (
        <button type="button" class="button small" onClick={() => onTry(MOST_BENT)}>
          {`Try flat to within ${MOST_BENT} mm/m`}
        </button>
      )}
    </div>
  );
}

/** Where panels stay bent, or some are split already: not beside cuts, which are of a flat mesh. */
function SplitPanels({ onChoose }: { onChoose: () => void }) {
  const page = usePage();
  const [preview, design] = [page.planariseTrial.value, page.draft.value];
  const share = splitShare(page);
  if (!design || design.settings.cuts.length > 0) return null;
  const bent = preview.kind === "shown" && !isMet(preview.trial, design);
  if (share.value === 0 && !bent && preview.kind !== "refused") return null;
  return (
    <>
      <Choice
        label="Split panels"
        value={String(share.value)}
        words={SPLIT_CHOICES}
        onChoose={(chosen) => {
          share.value = Number(chosen);
          onChoose();
        }}
      />
      <p class="quiet small">
        By lines between corners, as few as are found; points move less where more may be split.
      </p>
    </>
  );
}

interface OutcomeProps {
  readonly preview: Preview;
  readonly opened: OpenedMesh;
  readonly onTry: (flat: number) => void;
}

function Outcome({ preview, opened, onTry }: OutcomeProps) {
  const page = usePage();
  switch (preview.kind) {
    case "none":
      return <p class="quiet small">Move the slider to see on the model what it gives.</p>;
    case "running":
      return <p class="quiet small">Trying it on the model…</p>;
    case "refused":
      return <p class="note warn">{preview.sentence + ways(page.planarising.value)}</p>;
    case "shown": {
      const { trial } = preview;
      const short = page.draft.value && !isMet(trial, page.draft.value);
      return (
        <>
          <Figures trial={trial} opened={opened} />
          {short && <Short trial={trial} onTry={onTry} />}
        </>
      );
    }
  }
}

function hold(page: Page, on: boolean): void {
  page.showBefore.value = on;
}

function HoldFile() {
  const page = usePage();
  return (
    <button
      type="button"
      class="button small"
      aria-pressed={page.showBefore.value}
      title="Hold to see the file as it is (B)"
      onPointerDown={() => hold(page, true)}
      onPointerUp={() => hold(page, false)}
      onPointerLeave={() => hold(page, false)}
      onKeyDown={(event) => event.key === " " && hold(page, true)}
      onKeyUp={() => hold(page, false)}
      onBlur={() => hold(page, false)}
    >
      Before: the file
    </button>
  );
}

/** @param live whether it begins by itself */
export function PlanariseStep({ live }: { live: boolean }) {
  const page = usePage();
  const [opened, design] = [page.mesh.value, page.draft.value];
  const preview = useMemo(
    () => (opened && design ? new PlanarisePreview(page, opened, design) : null),
    [opened, design],
  );
  const wanted = (): Planarising => {
    const { keepShape = true, constraints = [] } = page.settings.peek() ?? {};
    return { ...page.planarising.peek(), keepShape, constraints };
  };
  const share = splitShare(page);
  const most = (): number =>
    share.peek() > 0
      ? Math.max(1, Math.floor((share.peek() / 100) * (opened?.report.faces ?? 0)))
      : 0;
  const show = (): void => void preview?.show(most(), wanted());
  const keep = (keepBoundary: boolean): void => {
    page.planarising.value = { ...page.planarising.peek(), keepBoundary };
  };
  const change = (changed: Partial<Planarising>): void => {
    page.planarising.value = { ...page.planarising.peek(), ...changed };
    show();
  };
  /** With the boundary where it is, unless that leaves panels bent. */
  const begin = async (): Promise<void> => {
    const first = wanted();
    const ways = first.keepBoundary ? [first, { ...first, keepBoundary: false }] : [first];
    const trial = await preview?.show(most(), ...ways);
    if (trial) keep(trial.how.keepBoundary);
  };
  useEffect(() => {
    if (!opened || !preview) return;
    share.value = 0;
    if (live) {
      const keepBoundary = canKeepBoundary(opened);
      page.planarising.value = { ...page.planarising.peek(), keepBoundary, within: 0, flat: 0 };
    }
    if (live && opened.report.vertices <= EAGER_POINTS) void begin();
    const view = viewOf(page);
    const stop = view && followSplitLines(page, view, opened);
    return () => {
      stop?.();
      preview.end();
    };
  }, [opened, preview, live]);
  if (!opened || !preview) return null;
  const { smooth, keepBoundary, within, flat } = page.planarising.value;
  const stop = stopOf(smooth);
  const name = NAMES[stop] ?? "";
  const choose = (place: number): void => {
    const chosen = STOPS[place] ?? 0;
    if (chosen === page.planarising.peek().smooth && page.planariseTrial.peek().kind !== "none")
      return;
    change({ smooth: chosen });
  };
  return (
    <>
      <Slider
        label="Aim for"
        value={stop}
        min={0}
        max={STOPS.length - 1}
        step={1}
        shown={name}
        spoken={name}
        disabled={!page.ready.value}
        ends={["close to the file", "fair folds"]}
        onInput={choose}
        onCommit={choose}
      />
      <label class="check">
        <input
          type="checkbox"
          checked={keepBoundary}
          onChange={({ currentTarget }) => change({ keepBoundary: currentTarget.checked })}
        />
        <span>Keep the boundary where it is</span>
      </label>
      <div class="planarise-bounds">
        <Choice
          label="Flat"
          value={String(flat)}
          words={FLATNESS_CHOICES}
          onChoose={(chosen) => change({ flat: Number(chosen) })}
        />
        <div class="field">
          <span aria-hidden="true">{`Largest move (${page.unit.value})`}</span>
          <LimitField
            label="Largest move"
            about={`${unitWord(page.unit.value)}, or any: no point moves farther`}
            zero="any"
            value={within}
            unit={page.unit.value}
            invalid={within < 0}
            onApply={(length) => change({ within: Math.max(0, length) })}
          />
        </div>
      </div>
      <Outcome
        preview={page.planariseTrial.value}
        opened={opened}
        onTry={(most) => change({ flat: most })}
      />
      <SplitPanels onChoose={show} />
      {page.planariseTrial.value.kind === "shown" && <HoldFile />}
    </>
  );
}

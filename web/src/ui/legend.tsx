// SPDX-License-Identifier: MIT
import type { RefObject } from "preact";
import { DARK, LIGHT, type Palette } from "../scene/palette.ts";
import { cssGradient, defectEnd, foldEnd, largest } from "../scene/ramp.ts";
import { formatDegrees } from "../state/fold.ts";
import { isKind, type Kind } from "../state/kept-kind.ts";
import {
  bending,
  type ColourBy,
  colourBy,
  figures,
  kindDefects,
  mesh,
  panelFolds,
  unit,
} from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { later } from "./later.tsx";

const Histogram = later(() => import("./histogram.tsx").then((part) => part.Histogram));

const HealthScale = later(() => import("./health-scale.tsx").then((part) => part.HealthScale));
const PlanarityScale = later(() =>
  import("./planarity-scale.tsx").then((part) => part.PlanarityScale),
);
const MobilityScale = later(() =>
  import("./mobility-scale.tsx").then((part) => part.MobilityScale),
);
const RemakeScale = later(() => import("./remake-scale.tsx").then((part) => part.RemakeScale));

const CHOICES: readonly (readonly [ColourBy, string])[] = [
  ["displacement", "Displacement"],
  ["planarity", "Planarity"],
  ["fold", "Folds"],
  ["fairness", "Fairness"],
  ["health", "Panel health"],
  ["remake", "Make again"],
  ["circular", "Circular"],
  ["conical", "Conical"],
  ["mobility", "Mobility"],
  ["zebra", "Reflection lines"],
  ["none", "Nothing"],
];

function Bar({ ramp }: { ramp: (palette: Palette) => readonly string[] }) {
  return (
    <>
      <div class="legend-bar light-only" style={{ backgroundImage: cssGradient(ramp(LIGHT)) }} />
      <div class="legend-bar dark-only" style={{ backgroundImage: cssGradient(ramp(DARK)) }} />
    </>
  );
}

type Linear = "displacement" | "fairness" | "fold" | Kind;

function ends(kind: Linear): readonly [string, string] {
  const { maxDisplacement } = figures.value;
  if (kind === "displacement")
    return ["0 mm, untouched", formatLength(maxDisplacement, unit.value)];
  if (kind === "fold") {
    const end = panelFolds.value ? foldEnd(panelFolds.value) : 0;
    return ["0°, flat", formatDegrees(end)];
  }
  if (isKind(kind)) {
    const end = kindDefects.value?.kind === kind ? defectEnd(kindDefects.value.values) : 0;
    return ["0°, kept", formatDegrees(end)];
  }
  const sharpest = bending.value ? largest(bending.value) : 0;
  return ["0 mm, smooth", formatLength(sharpest, unit.value)];
}

function Ends({ of }: { of: Linear }) {
  const [low, high] = ends(of);
  return (
    <div class="legend-ends">
      <span>{low}</span>
      <span>{high}</span>
    </div>
  );
}

function Scale() {
  const kind = colourBy.value;
  if (kind === "none") return null;
  if (kind === "zebra")
    return <p class="legend-note">Mirrored by the smooth surface through the points</p>;
  if (kind === "health") return <HealthScale />;
  if (kind === "remake") return <RemakeScale />;
  return (
    <>
      <Histogram />
      <Bar
        ramp={(palette) =>
          kind === "displacement" || kind === "mobility" ? palette.displacement : palette.planarity
        }
      />
      {kind === "planarity" ? (
        <PlanarityScale />
      ) : kind === "mobility" ? (
        <MobilityScale />
      ) : (
        <Ends of={kind} />
      )}
      {kind === "fairness" && <p class="legend-note">Difference between neighbours' moves</p>}
      {kind === "fold" && <p class="legend-note">Each panel's sharpest with a neighbour</p>}
      {kind === "circular" && <p class="legend-note">Opposite angles from 180° together</p>}
      {kind === "conical" && <p class="legend-note">Opposite angles' sums from each other</p>}
    </>
  );
}

/** Kinds of constraints only where the mesh has panels or nodes that could miss them. */
function choices(): readonly (readonly [ColourBy, string])[] {
  const kinds = mesh.value?.report.kinds;
  return CHOICES.filter(
    ([kind]) => !isKind(kind) || kind === colourBy.value || kinds?.[kind]?.worst !== undefined,
  );
}

/** What the colours of the model mean. */
export function Legend({ element }: { element: RefObject<HTMLFieldSetElement | null> }) {
  return (
    <fieldset ref={element} class="legend">
      <legend class="visually-hidden">Legend</legend>
      <label>
        <span class="legend-word">Colour by</span>
        <select
          class="select"
          value={colourBy.value}
          onChange={({ currentTarget }) => {
            colourBy.value = CHOICES.find(([kind]) => kind === currentTarget.value)?.[0] ?? "none";
          }}
        >
          {choices().map(([kind, label]) => (
            <option key={kind} value={kind}>
              {label}
            </option>
          ))}
        </select>
      </label>
      <Scale />
    </fieldset>
  );
}

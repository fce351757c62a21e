// SPDX-License-Identifier: MIT
import "./import-report.css";
import { useEffect, useRef } from "preact/hooks";
import type { MeshReport } from "../solver/protocol.ts";
import { damage, damageWords } from "../state/damage.ts";
import { flatnessWords } from "../state/flatness.ts";
import { isKeptBy, isMeant, KINDS, type Kind } from "../state/kept-kind.ts";
import { planarise } from "../state/opening.ts";
import { countHealth } from "../state/panel-rows.ts";
import { planarisingWords } from "../state/planarising.ts";
import {
  baseFlat,
  designName,
  draft,
  importReport,
  mesh,
  panelHealth,
  unit,
} from "../state/store.ts";
import { isUnit, UNITS, unitWord } from "../state/units.ts";
import { AcceptTolerance } from "./accept-tolerance.tsx";
import { later } from "./later.tsx";

const PlanariseStep = later(() =>
  import("./planarise-step.tsx").then((part) => part.PlanariseStep),
);

const SIZE_NAMES: Readonly<Record<string, string>> = {
  3: "triangles",
  4: "quads",
  5: "pentagons",
  6: "hexagons",
};

const faceWords = (sizes: MeshReport["faceSizes"]): string =>
  Object.entries(sizes)
    .map(([size, count]) => `${count} ${SIZE_NAMES[size] ?? `${size}-gons`}`)
    .join(", ");

type Fact = readonly [string, string];

/** What can be seen of the panels' outlines once they have been measured. */
function outlineFacts(): readonly Fact[] {
  if (!panelHealth.value) return [];
  const { concave, crossing } = countHealth(panelHealth.value);
  const spoilt = damage.value ? damageWords(damage.value, panelHealth.value) : "";
  const facts: Fact[] = [["Outlines", `${concave} concave, ${crossing} self-crossing`]];
  if (spoilt) facts.push(["Made flat, but", spoilt]);
  return facts;
}

function planarisingFacts(report: MeshReport): readonly Fact[] {
  const words = planarisingWords(report, unit.value);
  return words ? [["Planarised first", words]] : [];
}

const MADE_OF: Readonly<Record<Kind, string>> = {
  circular: "Circular panels",
  conical: "Conical nodes",
};

/** Kinds that the mesh is meant to keep; the step below has how. */
function meantFacts(report: MeshReport): readonly Fact[] {
  return KINDS.filter((kind) => isMeant(report, kind)).map((kind) => {
    if (isKeptBy(report, kind)) return [MADE_OF[kind], "exact; can be kept (Edit)"];
    const { median = 0, worst = 0 } = report.kinds[kind] ?? {};
    const [half, all] = [median, worst].map((degrees) => Number(degrees.toPrecision(2)));
    return [MADE_OF[kind], `half to ${half}°, all to ${all}°; can be made exact and kept (Edit)`];
  });
}

function Facts({ report }: { report: MeshReport }) {
  const { worstGap, worstMmPerM, worstExcess } = report;
  const facts: readonly Fact[] = [
    ["Points", String(report.vertices)],
    ["Panels", faceWords(report.faceSizes)],
    ["Worst panel", flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value).sentence],
    ...planarisingFacts(report),
    ...outlineFacts(),
    ...meantFacts(report),
    ["Boundary loops", String(report.boundaryLoops)],
    ["Separate parts", String(report.components)],
    ["Non-manifold edges", String(report.nonmanifoldEdges)],
  ];
  return (
    <dl class="facts">
      {facts.map(([name, value]) => (
        <div key={name}>
          <dt>{name}</dt>
          <dd>{value}</dd>
        </div>
      ))}
    </dl>
  );
}

function UnitChooser() {
  return (
    <label class="field">
      <span>Unit of the file</span>
      <select
        class="select"
        value={unit.value}
        onChange={({ currentTarget }) => {
          if (isUnit(currentTarget.value)) unit.value = currentTarget.value;
        }}
      >
        {UNITS.map((name) => (
          <option key={name} value={name}>
            {unitWord(name)}
          </option>
        ))}
      </select>
    </label>
  );
}

/** What was found in an opened file, and what to do if it is not flat. */
export function ImportReport() {
  const report = mesh.value?.report;
  const close = () => {
    importReport.value = false;
  };
  const section = useRef<HTMLElement>(null);
  // scrollIntoView would also move the page under a telephone's address bar.
  useEffect(() => section.current?.parentElement?.scrollTo(0, 0), [importReport.value]);
  if (!importReport.value) return null;
  return (
    <section ref={section} class="step import-report" aria-labelledby="import-title">
      <h2 id="import-title">{designName.value}</h2>
      {report && !baseFlat.value && (
        <p>
          <strong>Planarise first?</strong> Points can be moved once every panel is flat.
        </p>
      )}
      {report && !baseFlat.value && <PlanariseStep live={true} />}
      <AcceptTolerance />
      {report && <Facts report={report} />}
      {report?.warnings.map((warning) => (
        <p key={warning} class="quiet">
          {warning}
        </p>
      ))}
      <UnitChooser />
      <div class="dialog-actions">
        {report && !baseFlat.value ? (
          <>
            <button type="button" class="button" onClick={close}>
              Leave as it is
            </button>
            <button
              type="button"
              class="button primary"
              onClick={() =>
                void planarise().then(() => {
                  if (baseFlat.value) importReport.value = true;
                })
              }
            >
              Planarise
            </button>
          </>
        ) : (
          <button type="button" class="button primary" onClick={close}>
            {draft.value?.handles.length ? "Close" : "Start editing"}
          </button>
        )}
      </div>
    </section>
  );
}

// SPDX-License-Identifier: MIT
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";
import "./import-report.css";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { flatnessWords } from "../../design/flatness.ts";
import { isKeptBy, isMeant, KINDS, type Kind } from "../../design/kept-kind.ts";
import { planarisingWords } from "../../design/planarising.ts";
import type { UpAxis } from "../../mesh/up-axis.ts";
import { isUnit, UNITS, unitWord } from "../../quantity/units.ts";
import type { MeshReport } from "../../solver/protocol.ts";
import { damage, damageWords } from "../../state/damage.ts";
import { planarise } from "../../state/opening.ts";
import { countHealth } from "../../state/panel-rows.ts";
import { later } from "../../ui/later.tsx";
import { AcceptTolerance } from "../planarising/accept-tolerance.tsx";
import { joinPoints, joinTriangles, mayHaveLostQuads, turnPanels, warnsOf } from "./joining.ts";
import { guessedUnit, sizesOf, sizeWords } from "./unit-guess.ts";
import { canTurn, guessedUp, turnUp, upAxis } from "./up-axis.ts";

const PlanariseStep = later(() =>
  import("../planarising/planarise-step.tsx").then((part) => part.PlanariseStep),
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
function outlineFacts(page: Page): readonly Fact[] {
  if (!page.panelHealth.value) return [];
  const { concave, crossing } = countHealth(page.panelHealth.value);
  const done = damage(page).value;
  const spoilt = done ? damageWords(done, page.panelHealth.value) : "";
  const facts: Fact[] = [["Outlines", `${concave} concave, ${crossing} self-crossing`]];
  const edited = (page.draft.value?.shape.moved.length ?? 0) > 0;
  if (spoilt) facts.push([edited ? "After the edit" : "Made flat, but", spoilt]);
  return facts;
}

function sizeFacts(page: Page): readonly Fact[] {
  const points = page.mesh.value?.positions;
  return points ? [["Size", `${sizeWords(sizesOf(points))} ${page.unit.value}`]] : [];
}

function planarisingFacts(page: Page, report: MeshReport): readonly Fact[] {
  const words = planarisingWords(report, page.unit.value);
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
  const page = usePage();
  const { worstGap, worstMmPerM, worstExcess } = report;
  const facts: readonly Fact[] = [
    ...sizeFacts(page),
    ["Points", String(report.vertices)],
    ["Panels", faceWords(report.faceSizes)],
    ["Worst panel", flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value).sentence],
    ...planarisingFacts(page, report),
    ...outlineFacts(page),
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

/** Offers a unit where the size in the one chosen is that of no building, and in another it is. */
function UnitGuess() {
  const page = usePage();
  const points = page.mesh.value?.positions;
  const sizes = useMemo(() => (points ? sizesOf(points) : []), [points]);
  const guess = sizes.length > 0 ? guessedUnit(sizes, page.unit.value) : null;
  if (!guess) return null;
  return (
    <p class="unit-guess">
      {`Size ${sizeWords(sizes)}: ${unitWord(guess)}?`}
      <button
        type="button"
        class="button small"
        onClick={() => {
          page.unit.value = guess;
        }}
      >
        {`Yes, ${unitWord(guess)}`}
      </button>
    </p>
  );
}

function UnitChooser() {
  const page = usePage();
  return (
    <label class="field">
      <span>Unit of the file</span>
      <select
        class="select"
        value={page.unit.value}
        onChange={({ currentTarget }) => {
          if (isUnit(currentTarget.value)) page.unit.value = currentTarget.value;
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

const UPS: readonly UpAxis[] = ["z", "y", "x"];

function UpChooser() {
  const page = usePage();
  if (!canTurn(page)) return null;
  const guess = guessedUp(page).value?.toUpperCase();
  return (
    <>
      <label class="field">
        <span>Up in the file</span>
        <select
          class="select"
          value={upAxis(page).value}
          disabled={!page.ready.value || page.queued.value > 0}
          onChange={({ currentTarget }) => {
            const up = UPS.find((axis) => axis === currentTarget.value);
            if (up) void turnUp(page, up);
          }}
        >
          {UPS.map((axis) => (
            <option key={axis} value={axis}>
              {axis.toUpperCase()}
            </option>
          ))}
        </select>
      </label>
      {guess && (
        <p class="quiet small">
          Most panels face along {guess}: a roof has {guess} up then, a facade has not.
        </p>
      )}
    </>
  );
}

/** What can be done about what was found: labels of buttons, and what they do. */
function mendings(page: Page): readonly (readonly [string, (page: Page) => unknown])[] {
  return [
    ...(warnsOf(page, "--join-points") ? [["Join points", joinPoints] as const] : []),
    ...(warnsOf(page, "--orient") ? [["Turn panels to agree", turnPanels] as const] : []),
    ...(mayHaveLostQuads(page) ? [["Join triangles into quads", joinTriangles] as const] : []),
  ];
}

/** What was found in an opened file, and what to do if it is not flat. */
export function ImportReport() {
  const page = usePage();
  const report = page.mesh.value?.report;
  const close = () => {
    page.importReport.value = false;
  };
  const section = useRef<HTMLElement>(null);
  // scrollIntoView would also move the page under a telephone's address bar.
  useEffect(
    () => section.current?.closest(".inspector-body")?.scrollTo(0, 0),
    [page.importReport.value],
  );
  if (!page.importReport.value) return null;
  return (
    <section ref={section} class="step import-report" aria-labelledby="import-title">
      <h2 id="import-title">{page.designName.value}</h2>
      {report && !page.baseFlat.value && (
        <p>
          <strong>Planarise first?</strong> Points can be moved once every panel is flat, or once
          you choose to edit it as it is.
        </p>
      )}
      {report && !page.baseFlat.value && <PlanariseStep live={true} />}
      <AcceptTolerance />
      {report && <Facts report={report} />}
      {mendings(page).map(([label, mend]) => (
        <p key={label}>
          <button
            type="button"
            class="button"
            disabled={!page.ready.value}
            onClick={() => void mend(page)}
          >
            {label}
          </button>
        </p>
      ))}
      {report?.warnings.map((warning) => (
        <p key={warning} class="quiet">
          {warning}
        </p>
      ))}
      <UnitGuess />
      <UnitChooser />
      <UpChooser />
      <div class="dialog-actions">
        {report && !page.baseFlat.value ? (
          <>
            <button type="button" class="button" onClick={close}>
              Not now
            </button>
            <button
              type="button"
              class="button primary"
              onClick={() =>
                void planarise(page).then(() => {
                  if (page.baseFlat.value) page.importReport.value = true;
                })
              }
            >
              Planarise
            </button>
          </>
        ) : (
          <button type="button" class="button primary" onClick={close}>
            {page.draft.value?.handles.length ? "Close" : "Start editing"}
          </button>
        )}
      </div>
    </section>
  );
}

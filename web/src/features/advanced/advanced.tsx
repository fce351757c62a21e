// SPDX-License-Identifier: MIT

import { FIRST_SETTINGS, SOFT_LIMITS } from "../../design/design.ts";
import { decimal } from "../../design/flatness.ts";
import type { EditSettings } from "../../solver/protocol.ts";
import { commitSettings } from "../../state/editing.ts";
import { planarise } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { TOLERANCES } from "../../state/tolerance.ts";
import { Ask } from "../../ui/ask.tsx";
import { Check } from "../../ui/check.tsx";
import { Choice } from "../../ui/choice.tsx";
import { usePage } from "../../ui/page-context.ts";
import { KeptKinds } from "../constraints/kept-kinds.tsx";
import { RawWeights } from "./raw-weights.tsx";
import { VariationWeights } from "./variation-weights.tsx";

const FAIRNESS = [
  ["laplacian", "Laplacian"],
  ["second", "Second differences"],
  ["third", "Third differences"],
] as const;

const ENGINES = [
  ["newton", "Newton, fast"],
  ["alm", "Augmented Lagrangian, the paper's"],
] as const;

const OFFERED: readonly (readonly [string, string])[] = TOLERANCES.map((value) => [
  value,
  `${value} mm/m`,
]);

function wordOf<T extends string>(words: readonly (readonly [T, string])[], value: T): string {
  return words.find(([word]) => word === value)?.[1] ?? value;
}

const choose = (page: Page, change: Partial<EditSettings>): void =>
  void commitSettings(page, change);

/** What differs from the defaults, so that it is seen while folded: it stays for the next mesh. */
function differences(shown: EditSettings): string[] {
  const { fairness, engine, hardHandles, keepShape, tolerance, keepBends, softness } = shown;
  const different: string[] = [];
  if (softness === 0) different.push("raw weights");
  if (fairness !== FIRST_SETTINGS.fairness) different.push(wordOf(FAIRNESS, fairness));
  if (engine !== FIRST_SETTINGS.engine) different.push(wordOf(ENGINES, engine));
  if (tolerance !== FIRST_SETTINGS.tolerance) different.push(`${tolerance} mm/m`);
  if (keepBends) different.push("panels stay bent");
  if (hardHandles !== FIRST_SETTINGS.hardHandles) different.push("exact targets");
  if (keepShape !== FIRST_SETTINGS.keepShape) different.push("panels may lose their shape");
  return different;
}

function Differences({ of }: { of: EditSettings }) {
  const page = usePage();
  const words = differences(of).join(", ");
  if (words === "") return null;
  const { fairness, engine, hardHandles, keepShape, tolerance, keepBends } = FIRST_SETTINGS;
  const ofMesh = of.keepBends || page.toleranceTaken.value;
  const stays = ofMesh ? "How flat panels are goes" : "It stays";
  const back = { fairness, engine, hardHandles, keepShape, tolerance, keepBends };
  return (
    <div class="differences">
      <p class="quiet small">{`Not the default: ${words}. ${stays} when you open another mesh.`}</p>
      <button
        type="button"
        class="button small"
        disabled={!page.ready.value}
        onClick={() => choose(page, of.softness === 0 ? { ...back, ...SOFT_LIMITS } : back)}
      >
        Defaults
      </button>
    </div>
  );
}

/** Why a tolerance was not taken, and the way to get it. */
function RefusedTolerance() {
  const page = usePage();
  const refused = page.refusedTolerance.value;
  const report = page.mesh.value?.report;
  if (refused === null || !report) return null;
  return (
    <div class="note warn" role="alert">
      <p>
        {`The mesh itself is out of flat by up to ${decimal(report.worstMmPerM)} mm/m, more than ${refused} mm/m. Planarise makes it flat and does the edit again.`}
      </p>
      <button type="button" class="button primary" onClick={() => void planarise(page)}>
        Planarise
      </button>
    </div>
  );
}

/** The settings that few need. */
export function Advanced() {
  const page = usePage();
  const shown = page.settings.value ?? FIRST_SETTINGS;
  const { fairness, engine, hardHandles, keepShape, tolerance, keepBends } = shown;
  // The chooser goes back to what holds.
  page.refusedTolerance.value;
  const known = OFFERED.find(([value]) => Number(value) === tolerance);
  // A link or a file may have set another.
  const given = [String(tolerance), `${tolerance} mm/m`] as const;
  return (
    <div class="disclosure">
      <details>
        <summary>Advanced</summary>
        <Ask about="advanced" />
        <RawWeights />
        <Choice
          label="Fairness"
          value={fairness}
          words={FAIRNESS}
          onChoose={(value) => choose(page, { fairness: value })}
        />
        <Choice
          label="Engine"
          value={engine}
          words={ENGINES}
          onChoose={(value) => choose(page, { engine: value })}
        />
        <Choice
          label="Tolerance"
          value={known?.[0] ?? given[0]}
          words={known ? OFFERED : [...OFFERED, given]}
          onChoose={(value) => {
            page.toleranceTaken.value = false;
            choose(page, { tolerance: Number(value), keepBends: false });
          }}
        />
        <p class="quiet small">
          {keepBends
            ? "Panels stay as bent as they are, none bends more."
            : "Panels count as flat up to the tolerance."}
        </p>
        <RefusedTolerance />
        <Check
          label="Meet the targets exactly"
          checked={hardHandles}
          disabled={!page.ready.value}
          onChange={(on) => choose(page, { hardHandles: on })}
        />
        <Check
          label="Panels keep their shape"
          checked={keepShape}
          disabled={!page.ready.value}
          onChange={(on) => choose(page, { keepShape: on })}
        />
        <p class="quiet small">None becomes concave, crossing, turned over or collapsed.</p>
        <KeptKinds offered={false} />
        <VariationWeights />
      </details>
      <Differences of={shown} />
    </div>
  );
}

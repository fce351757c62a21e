// SPDX-License-Identifier: MIT
// Circular panels and conical nodes, kept by edits of meshes that are made of them.

import { FIRST_SETTINGS } from "../../design/design.ts";
import { isKeptBy, isMeant, KINDS, type Kind, kindOf, withKind } from "../../design/kept-kind.ts";
import { commitSettings } from "../../state/editing.ts";
import { makeKept } from "../../state/opening.ts";
import type { Page } from "../../state/page.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";

const LABELS: Readonly<Record<Kind, string>> = {
  circular: "Keep panels circular",
  conical: "Keep nodes conical",
};

const kept = (page: Page): readonly string[] => (page.settings.value ?? FIRST_SETTINGS).constraints;

const isOn = (page: Page, kind: Kind): boolean => kept(page).some((one) => kindOf(one) === kind);

function choose(page: Page, kind: Kind, on: boolean): void {
  const others = kept(page).filter((one) => kindOf(one) !== kind);
  void commitSettings(page, { constraints: on ? withKind(others, kind) : others });
}

const MAKE: Readonly<Record<Kind, string>> = {
  circular: "Make panels circular",
  conical: "Make nodes conical",
};

/** What the mesh itself is, where an edit cannot keep it. */
function nearWords(page: Page, kind: Kind): string {
  const report = page.mesh.value?.report;
  const defects = report?.kinds[kind];
  if (!report || !defects || isKeptBy(report, kind)) return "";
  const worst = Number((defects.worst ?? 0).toPrecision(2));
  return `The mesh misses it by up to ${worst}°. Making it so moves points of the mesh itself.`;
}

function KeptKind({ kind }: { kind: Kind }) {
  const page = usePage();
  const words = nearWords(page, kind);
  return (
    <>
      <Check
        label={LABELS[kind]}
        checked={isOn(page, kind)}
        disabled={!page.ready.value || (words !== "" && !isOn(page, kind))}
        onChange={(on) => choose(page, kind, on)}
      />
      {words && (
        <>
          <p class="quiet small">{words}</p>
          <button
            type="button"
            class="button"
            disabled={!page.ready.value}
            onClick={() => void makeKept(page, kind)}
          >
            {MAKE[kind]}
          </button>
        </>
      )}
    </>
  );
}

/** Whether there is anything in the mesh that could miss it. */
const isPossible = (page: Page, kind: Kind): boolean =>
  isOn(page, kind) || page.mesh.value?.report.kinds[kind]?.worst !== undefined;

/** Offered where a mesh is meant to be so, or where it is on; the others stand in Advanced. */
function isOffered(page: Page, kind: Kind): boolean {
  const report = page.mesh.value?.report;
  return isOn(page, kind) || (report !== undefined && isMeant(report, kind));
}

export function KeptKinds({ offered }: { offered: boolean }) {
  const page = usePage();
  return (
    <>
      {KINDS.filter((kind) => isPossible(page, kind) && isOffered(page, kind) === offered).map(
        (kind) => (
          <KeptKind key={kind} kind={kind} />
        ),
      )}
    </>
  );
}

export const OfferedKinds = () => <KeptKinds offered />;

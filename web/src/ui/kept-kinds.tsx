// SPDX-License-Identifier: MIT
// Circular panels and conical nodes, kept by edits of meshes that are made of them.
import { FIRST_SETTINGS } from "../state/design.ts";
import { commitSettings } from "../state/editing.ts";
import { isKeptBy, isMeant, KINDS, type Kind, kindOf, withKind } from "../state/kept-kind.ts";
import { makeKept } from "../state/opening.ts";
import { mesh, ready, settings } from "../state/store.ts";

const LABELS: Readonly<Record<Kind, string>> = {
  circular: "Keep panels circular",
  conical: "Keep nodes conical",
};

const kept = (): readonly string[] => (settings.value ?? FIRST_SETTINGS).constraints;
const isOn = (kind: Kind): boolean => kept().some((one) => kindOf(one) === kind);

function choose(kind: Kind, on: boolean): void {
  const others = kept().filter((one) => kindOf(one) !== kind);
  void commitSettings({ constraints: on ? withKind(others, kind) : others });
}

const MAKE: Readonly<Record<Kind, string>> = {
  circular: "Make panels circular",
  conical: "Make nodes conical",
};

/** What the mesh itself is, where an edit cannot keep it. */
function nearWords(kind: Kind): string {
  const report = mesh.value?.report;
  const defects = report?.kinds[kind];
  if (!report || !defects || isKeptBy(report, kind)) return "";
  const worst = Number((defects.worst ?? 0).toPrecision(2));
  return `The mesh misses it by up to ${worst}°. Making it so moves points of the mesh itself.`;
}

function KeptKind({ kind }: { kind: Kind }) {
  const words = nearWords(kind);
  return (
    <>
      <label class="check">
        <input
          type="checkbox"
          checked={isOn(kind)}
          disabled={!ready.value || (words !== "" && !isOn(kind))}
          onChange={({ currentTarget }) => choose(kind, currentTarget.checked)}
        />
        <span>{LABELS[kind]}</span>
      </label>
      {words && (
        <>
          <p class="quiet small">{words}</p>
          <button
            type="button"
            class="button"
            disabled={!ready.value}
            onClick={() => void makeKept(kind)}
          >
            {MAKE[kind]}
          </button>
        </>
      )}
    </>
  );
}

/** Whether there is anything in the mesh that could miss it. */
const isPossible = (kind: Kind): boolean =>
  isOn(kind) || mesh.value?.report.kinds[kind]?.worst !== undefined;

/** Offered where a mesh is meant to be so, or where it is on; the others stand in Advanced. */
function isOffered(kind: Kind): boolean {
  const report = mesh.value?.report;
  return isOn(kind) || (report !== undefined && isMeant(report, kind));
}

export function KeptKinds({ offered }: { offered: boolean }) {
  return (
    <>
      {KINDS.filter((kind) => isPossible(kind) && isOffered(kind) === offered).map((kind) => (
        <KeptKind key={kind} kind={kind} />
      ))}
    </>
  );
}

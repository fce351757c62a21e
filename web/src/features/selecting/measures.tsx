// SPDX-License-Identifier: MIT
// Distances, angles and levels of the selected points, as values to copy.
import { useSignal } from "@preact/signals";
import "./selection-strip.css";
import { NO_SHAPE, type Point } from "../../design/design.ts";
import { type Measure, measures } from "../../mesh/measuring.ts";
import { formatLength, type Unit } from "../../quantity/units.ts";
import { basePoint } from "../../state/editing.ts";
import type { Page } from "../../state/page.ts";
import { Ask } from "../../ui/ask.tsx";
import { usePage } from "../../ui/page-context.ts";

/** Where the selected points are now, in the order in which they were selected; model units. */
function selectedPoints(page: Page): Point[] {
  const { moved, positions } = page.draft.value?.shape ?? NO_SHAPE;
  const places = new Map([...moved].map((vertex, k) => [vertex, 3 * k]));
  return page.selection.value.map((vertex) => {
    const at = places.get(vertex);
    if (at === undefined) return basePoint(page, vertex);
    return [positions[at] ?? 0, positions[at + 1] ?? 0, positions[at + 2] ?? 0];
  });
}

const shown = ({ value, kind }: Measure, unit: Unit): string =>
  kind === "length" ? formatLength(value, unit) : `${value.toFixed(3)}°`;

/** A line each, for a table: the name, every digit, the unit. */
const copied = (all: readonly Measure[], unit: Unit): string =>
  all
    .map(({ name, value, kind }) => `${name}\t${value}\t${kind === "length" ? unit : "°"}`)
    .join("\n");

function Copy({ all }: { all: readonly Measure[] }) {
  const page = usePage();
  const done = useSignal("");
  const copy = async (): Promise<void> => {
    const written = navigator.clipboard.writeText(copied(all, page.unit.value));
    done.value = await written.then(
      () => "Copied",
      () => "The browser does not let the page copy.",
    );
  };
  return (
    <>
      <button
        type="button"
        class="tool"
        title="Copies these values with every digit"
        onClick={() => void copy()}
      >
        Copy
      </button>
      <span aria-live="polite">{done.value}</span>
    </>
  );
}

function Values() {
  const page = usePage();
  const all = measures(selectedPoints(page));
  return (
    <>
      <dl>
        {all.map((measure) => (
          <div key={measure.name}>
            <dt>{measure.name}</dt>
            <dd>{shown(measure, page.unit.value)}</dd>
          </div>
        ))}
      </dl>
      <Copy all={all} />
    </>
  );
}

/** Measures only while it is unfolded. */
export function Measures() {
  const page = usePage();
  const open = useSignal(false);
  if (page.selection.value.length < 2) return null;
  return (
    <details
      class="measures"
      onToggle={({ currentTarget }) => {
        open.value = currentTarget.open;
      }}
    >
      <summary>Measure</summary>
      <Ask about="measure" />
      {open.value && <Values />}
    </details>
  );
}

// SPDX-License-Identifier: MIT
// Where the point chosen last is: in the file, from a point of one's own, and from where it was.

import { computed, signal, useSignal } from "@preact/signals";
import { NO_SHAPE, type Point } from "../../design/design.ts";
import { minus } from "../../mesh/vector.ts";
import { formatCoordinate } from "../../quantity/units.ts";
import type { OpenedMesh } from "../../solver/protocol.ts";
import { basePoint, shownPoint } from "../../state/editing.ts";
import { kept, type Page } from "../../state/page.ts";
import { settled } from "../../state/shortfall.ts";
import { Ask } from "../../ui/ask.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./position.css";

// Places of a survey have seven digits before the point; those from a point of the mesh can be read.
const chosen = kept(() => signal<{ opened: WeakRef<OpenedMesh>; vertex: number } | null>(null));

/** The point, of the mesh that is open, that places are given from; null: the origin of the file. */
const localOrigin = kept((page: Page) =>
  computed(() => {
    const origin = chosen(page).value;
    return origin && origin.opened.deref() === page.mesh.value ? origin.vertex : null;
  }),
);

function setLocalOrigin(page: Page, vertex: number | null): void {
  const opened = page.mesh.value;
  chosen(page).value = opened && vertex !== null ? { opened: new WeakRef(opened), vertex } : null;
}

type Line = readonly [name: string, place: Point];

function lines(page: Page, vertex: number): readonly Line[] {
  const shape = page.draft.value?.shape ?? NO_SHAPE;
  const place = shownPoint(page, vertex, shape);
  const origin = localOrigin(page).value;
  const from: Line[] =
    origin === null
      ? []
      : [[`From point ${origin}`, minus(place, shownPoint(page, origin, shape))]];
  return [["In the file", place], ...from, ["Moved by", minus(place, basePoint(page, vertex))]];
}

function Places({ vertex }: { vertex: number }) {
  const page = usePage();
  return (
    <table class={settled(page).value ? "" : "stale"} aria-label={`Position of point ${vertex}`}>
      <thead>
        <tr>
          <th scope="col">Point {vertex}</th>
          {["X", "Y", "Z"].map((axis) => (
            <th key={axis} scope="col">
              {axis} <span class="unit">{page.unit.value}</span>
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {lines(page, vertex).map(([name, place]) => (
          <tr key={name}>
            <th scope="row">{name}</th>
            {place.map((x, axis) => (
              <td key={axis}>{formatCoordinate(x)}</td>
            ))}
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** Chooses where places are given from: a point, or null for the file's own. */
function OriginButton({ of, title, label }: { of: number | null; title: string; label: string }) {
  const page = usePage();
  return (
    <button
      type="button"
      class="button small"
      title={title}
      aria-pressed={localOrigin(page).value === of}
      onClick={() => setLocalOrigin(page, of)}
    >
      {label}
    </button>
  );
}

function Origin({ vertex }: { vertex: number }) {
  return (
    <div class="row">
      <OriginButton
        of={vertex}
        title="Shows the coordinates of other points from this one"
        label="Origin here"
      />
      <OriginButton
        of={null}
        title="Shows coordinates as in the file again"
        label="Origin of the file"
      />
    </div>
  );
}

/** Followed only while it is unfolded. */
export function Position() {
  const page = usePage();
  const open = useSignal(false);
  const vertex = page.selected.value;
  return (
    <details
      class="surface-move position"
      onToggle={({ currentTarget }) => {
        open.value = currentTarget.open;
      }}
    >
      <summary>Position</summary>
      <Ask about="position" />
      {open.value && vertex === null && <p class="quiet">Select a point first.</p>}
      {open.value && vertex !== null && (
        <>
          <Places vertex={vertex} />
          <Origin vertex={vertex} />
        </>
      )}
    </details>
  );
}

// SPDX-License-Identifier: MIT
// Several points are one thing: what can be done with all that are selected, and how to select more.
import "./selection-strip.css";
import type { Point } from "../state/design.ts";
import { FLAT_FIRST, moveTogether } from "../state/dragging.ts";
import { freePins, removeHandles, setPinned } from "../state/editing.ts";
import {
  growSelection,
  selectBoundary,
  selectedEdge,
  selectLine,
  selectOthers,
  selectRing,
  shrinkSelection,
} from "../state/selecting-more.ts";
import { baseFlat, handles, mesh, ready, selection, unit } from "../state/store.ts";
import { niceStep } from "../state/units.ts";
import { NumberField } from "./number-field.tsx";

const AXES: readonly (readonly [string, Point])[] = [
  ["X", [1, 0, 0]],
  ["Y", [0, 1, 0]],
  ["Z", [0, 0, 1]],
];

interface ToolProps {
  readonly name: string;
  readonly about: string;
  readonly disabled?: boolean;
  readonly onClick: () => void;
}

function Tool({ name, about, disabled, onClick }: ToolProps) {
  return (
    <button type="button" class="tool" title={about} disabled={disabled ?? false} onClick={onClick}>
      {name}
    </button>
  );
}

function MoveFields({ disabled }: { disabled: boolean }) {
  const chosen = selection.value;
  return (
    <span class="strip-part">
      <span class="strip-move">Move by</span>
      {AXES.map(([axis, [x, y, z]]) => (
        <span key={axis} class="strip-move">
          {axis}
          <NumberField
            label={`Move by ${axis}`}
            value={0}
            unit={unit.value}
            step={niceStep((mesh.value?.report.meanEdge ?? 1) / 100)}
            disabled={disabled}
            context={`all selected points together, along ${axis}`}
            onApply={(by) => void moveTogether(chosen, [x * by, y * by, z * by])}
          />
        </span>
      ))}
      <span class="strip-move">{unit.value}</span>
    </span>
  );
}

function DoTools({ disabled }: { disabled: boolean }) {
  const chosen = selection.value;
  const rows = handles.value.filter(({ vertex }) => chosen.includes(vertex));
  const pins = rows.filter(({ pinned }) => pinned);
  return (
    <span class="strip-part">
      <Tool
        name="Pin"
        about="Pinned points do not move"
        disabled={disabled || pins.length === chosen.length}
        onClick={() => void setPinned(chosen, true)}
      />
      <Tool
        name="Free"
        about="Lets the pinned ones go"
        disabled={disabled || pins.length === 0}
        onClick={() => void freePins(chosen)}
      />
      <Tool
        name="Remove"
        about="Removes their handles and pins"
        disabled={disabled || rows.length === 0}
        onClick={() => void removeHandles(chosen)}
      />
    </span>
  );
}

function SelectTools({ none }: { none: boolean }) {
  const noEdge = selectedEdge() === null;
  return (
    <span class="strip-part">
      <Tool name="Boundary" about="Adds the points of the boundary" onClick={selectBoundary} />
      <Tool
        name="Line"
        about="Adds the line of the mesh through the two neighbours selected last (double click on an edge)"
        disabled={noEdge}
        onClick={selectLine}
      />
      <Tool
        name="Ring"
        about="Adds the strip of panels across the two neighbours selected last (Alt and double click on an edge)"
        disabled={noEdge}
        onClick={selectRing}
      />
      <Tool name="Invert" about="Selects all the other points" onClick={selectOthers} />
      <Tool name="Grow" about="Adds the neighbours" disabled={none} onClick={growSelection} />
      <Tool
        name="Shrink"
        about="Leaves out the points at the edge of the selection"
        disabled={none}
        onClick={shrinkSelection}
      />
    </span>
  );
}

export function SelectionStrip() {
  const { length } = selection.value;
  const fixed = length === 0 || !ready.value || !baseFlat.value;
  return (
    <div
      class="selection-strip"
      role="toolbar"
      aria-label="Selected points"
      title={baseFlat.value ? undefined : FLAT_FIRST}
    >
      <span class="strip-count">{length === 1 ? "1 point" : `${length} points`}</span>
      <DoTools disabled={fixed} />
      <MoveFields disabled={fixed} />
      <SelectTools none={length === 0} />
    </div>
  );
}

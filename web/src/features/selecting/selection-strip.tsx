// SPDX-License-Identifier: MIT
// Several points are one thing: what can be done with all that are selected, and how to select more.

import type { RefObject } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { counted } from "../../quantity/counted.ts";
import { usePage } from "../../ui/page-context.ts";
import "./selection-strip.css";
import type { Point } from "../../design/design.ts";
import { niceStep } from "../../quantity/units.ts";
import { FLAT_FIRST } from "../../state/dragging.ts";
import { moveTogether } from "../../state/typed-moves.ts";
import { Ask } from "../../ui/ask.tsx";
import { CommandButton } from "../../ui/command-button.tsx";
import type { Command } from "../../ui/commands/command.ts";
import { NumberField } from "../../ui/number-field.tsx";
import { SelectionSight } from "../../ui/places.ts";
import { Measures } from "./measures.tsx";
import { cannotEdit, SELECTION_COMMANDS } from "./selection-commands.ts";

const AXES: readonly (readonly [string, Point])[] = [
  ["X", [1, 0, 0]],
  ["Y", [0, 1, 0]],
  ["Z", [0, 0, 1]],
];

/** With what its title says of it beside its label. */
type Tool = readonly [command: Command, hint: string];

const DO: readonly Tool[] = [
  [SELECTION_COMMANDS.pinSelected, "pinned points do not move"],
  [SELECTION_COMMANDS.freeSelected, "lets the pinned ones go"],
  [SELECTION_COMMANDS.removeSelected, "their pins, too"],
];

const SELECT: readonly Tool[] = [
  [SELECTION_COMMANDS.selectBoundary, "adds its points"],
  [
    SELECTION_COMMANDS.selectLine,
    "adds the one through the two neighbours selected last (double click on an edge)",
  ],
  [
    SELECTION_COMMANDS.selectRing,
    "adds the one across the two neighbours selected last (Alt and double click on an edge)",
  ],
  [SELECTION_COMMANDS.selectOthers, "all the other points"],
  [SELECTION_COMMANDS.growSelection, "adds the neighbours"],
  [SELECTION_COMMANDS.shrinkSelection, "leaves out the points at its edge"],
];

function Tools({ tools }: { tools: readonly Tool[] }) {
  return (
    <span class="strip-part">
      {tools.map(([command, hint]) => (
        <CommandButton key={command.label} look="tool" command={command} hint={hint} />
      ))}
    </span>
  );
}

/** The field that a key asked for has the focus, its number selected. */
function useAskedField(): RefObject<HTMLSpanElement | null> {
  const page = usePage();
  const fields = useRef<HTMLSpanElement>(null);
  const axis = page.typedMove.value;
  useEffect(() => {
    if (axis)
      fields.current?.querySelector<HTMLInputElement>(`[aria-label="Move by ${axis}"]`)?.select();
  }, [axis]);
  return fields;
}

function MoveFields({ disabled }: { disabled: boolean }) {
  const page = usePage();
  const chosen = page.selection.value;
  const fields = useAskedField();
  return (
    <span class="strip-part" ref={fields}>
      <span class="strip-move">Move by</span>
      {AXES.map(([axis, [x, y, z]]) => (
        <span key={axis} class="strip-move">
          {axis}
          <NumberField
            label={`Move by ${axis}`}
            value={0}
            unit={page.unit.value}
            step={niceStep((page.mesh.value?.report.meanEdge ?? 1) / 100)}
            disabled={disabled}
            context={`all selected points together, along ${axis}${page.fallOff.value > 0 ? "; those further out by less" : ""}`}
            onApply={(by) => void moveTogether(page, chosen, [x * by, y * by, z * by])}
          />
        </span>
      ))}
      <span class="strip-move">{page.unit.value}</span>
    </span>
  );
}

/** The outer share of the group over which its move falls off. */
const FALL_OFFS: readonly (readonly [number, string])[] = [
  [0, "none"],
  [0.35, "at the rim"],
  [0.65, "half way"],
  [1, "from the middle"],
];

function FallOff() {
  const page = usePage();
  return (
    <label
      class="strip-move"
      title="Points further out move less: a bump, not a mesa. A drag falls off from the point that is dragged, typed amounts are those of the middle"
    >
      Fall-off
      <select
        class="select"
        value={page.fallOff.value}
        onChange={({ currentTarget }) => {
          page.fallOff.value = Number(currentTarget.value);
        }}
      >
        {FALL_OFFS.map(([share, words]) => (
          <option key={share} value={share}>
            {words}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Where several points are selected, or about to be; beside the view, to cover none of them. */
export function SelectionStrip() {
  const page = usePage();
  const { length } = page.selection.value;
  if (length < 2 && !page.areaTool.value && !page.typedMove.value) return null;
  return (
    <div
      class="selection-strip"
      role="toolbar"
      aria-label="Selected points"
      title={page.baseFlat.value ? undefined : FLAT_FIRST}
      onFocusOut={({ currentTarget, relatedTarget }) => {
        if (!currentTarget.contains(relatedTarget as Node | null)) page.typedMove.value = null;
      }}
    >
      <span class="strip-count">{counted(length, "point")}</span>
      <Ask about="several" />
      <Tools tools={DO} />
      <MoveFields disabled={cannotEdit(page) !== ""} />
      <FallOff />
      <SelectionSight />
      <Tools tools={SELECT} />
      <Measures />
    </div>
  );
}

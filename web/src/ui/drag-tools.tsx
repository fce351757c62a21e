// SPDX-License-Identifier: MIT
// How a drag in the view goes: held to an axis or a plane, in steps, or around points as a box.

import type { ComponentChildren } from "preact";
import { allPinned, FLAT_FIRST, toggleLock, togglePins } from "../state/dragging.ts";
import type { AreaTool, Lock } from "../state/page-state.ts";
import { Ask } from "./ask.tsx";
import { type Command, keyOf, refusalOf } from "./commands/command.ts";
import { COMMANDS } from "./commands/commands.ts";
import { Icon, type IconName } from "./icon.tsx";
import { NumberField } from "./number-field.tsx";
import { usePage } from "./page-context.ts";
import { ClickTools, LastTools } from "./places.ts";

interface ToggleProps {
  readonly name: string;
  /** What is written beside its icon in a wide view: a word of the name. */
  readonly word?: string;
  readonly about: string;
  readonly on: boolean;
  readonly disabled?: boolean;
  readonly kind?: string;
  readonly onClick: () => void;
  readonly children: ComponentChildren;
}

export function Toggle({ name, word, about, on, disabled, kind, onClick, children }: ToggleProps) {
  return (
    <button
      type="button"
      class={`tool ${kind ?? ""}`}
      aria-label={name}
      data-word={word}
      aria-pressed={on}
      title={`${name}: ${about}`}
      disabled={disabled ?? false}
      onClick={onClick}
    >
      {children}
    </button>
  );
}

const LOCKS: readonly (readonly [Lock["axis"], Command])[] = [
  ["x", COMMANDS.lockX],
  ["y", COMMANDS.lockY],
  ["z", COMMANDS.lockZ],
  ["normal", COMMANDS.lockNormal],
];

function LockTools() {
  const page = usePage();
  const held = page.lock.value;
  return (
    <>
      {LOCKS.map(([axis, command]) => (
        <Toggle
          key={axis}
          kind={`axis ${axis}`}
          name={command.label}
          about={`drags stay on this line (${keyOf(command)}); with Shift, in the plane across it`}
          on={held?.axis === axis}
          onClick={() => toggleLock(page, axis, held?.plane ?? false)}
        >
          {keyOf(command)}
        </Toggle>
      ))}
      <Toggle
        name="Lock to the plane across"
        word="Plane"
        about="drags stay in the plane at right angles to the chosen axis"
        on={held?.plane ?? false}
        disabled={!held}
        onClick={() => {
          if (held) page.lock.value = { ...held, plane: !held.plane };
        }}
      >
        <Icon name="plane" />
      </Toggle>
    </>
  );
}

function SnapTools() {
  const page = usePage();
  return (
    <>
      <Toggle
        name="Snap"
        word="Snap"
        about="drags go in steps, and back to the base position (Ctrl while dragging)"
        on={page.snapping.value}
        onClick={() => {
          page.snapping.value = !page.snapping.value;
        }}
      >
        <Icon name="snap" />
      </Toggle>
      <span class={page.snapping.value ? "snap-step" : "snap-step off"}>
        <NumberField
          label="Snap step"
          value={page.snapDistance.value}
          unit={page.unit.value}
          step={page.snapDistance.value / 10}
          disabled={!page.mesh.value}
          context="step of a drag"
          onApply={(value) => {
            if (value > 0) page.snapStep.value = value;
          }}
        />
        <span class="unit">{page.unit.value}</span>
      </span>
    </>
  );
}

const AREAS: readonly (readonly [AreaTool, string, string, string, IconName])[] = [
  ["box", "Select in a box", "Box", "the next drag selects the points in a box", "selectBox"],
  [
    "lasso",
    "Select in a loop",
    "Loop",
    "the next drag selects the points that it goes round",
    "lasso",
  ],
];

function AreaTools() {
  const page = usePage();
  return AREAS.map(([tool, name, word, about, icon]) => (
    <Toggle
      key={tool}
      name={name}
      word={word}
      about={`${about}; with Shift, adds them`}
      on={page.areaTool.value === tool}
      disabled={!page.ready.value}
      onClick={() => {
        page.areaTool.value = page.areaTool.value === tool ? null : tool;
      }}
    >
      <Icon name={icon} />
    </Toggle>
  ));
}

function PinTool() {
  const page = usePage();
  return (
    <Toggle
      name={COMMANDS.pin.label}
      word="Pin"
      about={
        page.baseFlat.value ? `pinned points do not move (${keyOf(COMMANDS.pin)})` : FLAT_FIRST
      }
      on={allPinned(page)}
      disabled={refusalOf(page, COMMANDS.pin) !== ""}
      onClick={() => togglePins(page)}
    >
      <Icon name="pin" />
    </Toggle>
  );
}

export function DragTools() {
  const page = usePage();
  const resting =
    page.selection.value.length === 0 && !page.areaTool.value && page.selectedPanel.value === null;
  return (
    <div
      class={resting ? "drag-tools resting" : "drag-tools"}
      role="toolbar"
      aria-label="Drag tools"
    >
      <AreaTools />
      <PinTool />
      <ClickTools />
      <span class="tool-gap" />
      <LockTools />
      <Toggle
        name="Local arrows"
        word="Local"
        about="arrows follow the surface at the point instead of X, Y and Z"
        on={page.localArrows.value}
        onClick={() => {
          page.localArrows.value = !page.localArrows.value;
        }}
      >
        <Icon name="local" />
      </Toggle>
      <span class="tool-gap" />
      <SnapTools />
      <LastTools />
      <Ask about="tools" />
    </div>
  );
}

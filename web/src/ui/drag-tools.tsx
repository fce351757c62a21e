// SPDX-License-Identifier: MIT
// How a drag in the view goes: held to an axis or a plane, in steps, or around points as a box.
import type { ComponentChildren } from "preact";
import { allPinned, FLAT_FIRST, toggleLock, togglePins } from "../state/dragging.ts";
import {
  baseFlat,
  boxTool,
  type Lock,
  localArrows,
  lock,
  mesh,
  ready,
  selection,
  snapDistance,
  snapping,
  snapStep,
  unit,
} from "../state/store.ts";
import { Icon } from "./icon.tsx";
import { NumberField } from "./number-field.tsx";

interface ToggleProps {
  readonly name: string;
  readonly about: string;
  readonly on: boolean;
  readonly disabled?: boolean;
  readonly kind?: string;
  readonly onClick: () => void;
  readonly children: ComponentChildren;
}

function Toggle({ name, about, on, disabled, kind, onClick, children }: ToggleProps) {
  return (
    <button
      type="button"
      class={`tool ${kind ?? ""}`}
      aria-label={name}
      aria-pressed={on}
      title={`${name}: ${about}`}
      disabled={disabled ?? false}
      onClick={onClick}
    >
      {children}
    </button>
  );
}

const LOCKS: readonly (readonly [Lock["axis"], string, string])[] = [
  ["x", "X", "Lock to X"],
  ["y", "Y", "Lock to Y"],
  ["z", "Z", "Lock to Z"],
  ["normal", "N", "Lock to normal"],
];

function LockTools() {
  const held = lock.value;
  return (
    <>
      {LOCKS.map(([axis, letter, name]) => (
        <Toggle
          key={axis}
          kind={`axis ${axis}`}
          name={name}
          about={`drags stay on this line (${letter}); with Shift, in the plane across it`}
          on={held?.axis === axis}
          onClick={() => toggleLock(axis, held?.plane ?? false)}
        >
          {letter}
        </Toggle>
      ))}
      <Toggle
        name="Lock to the plane across"
        about="drags stay in the plane at right angles to the chosen axis"
        on={held?.plane ?? false}
        disabled={!held}
        onClick={() => {
          if (held) lock.value = { ...held, plane: !held.plane };
        }}
      >
        <Icon name="plane" />
      </Toggle>
    </>
  );
}

function SnapTools() {
  return (
    <>
      <Toggle
        name="Snap"
        about="drags go in steps, and back to the base position (Ctrl while dragging)"
        on={snapping.value}
        onClick={() => {
          snapping.value = !snapping.value;
        }}
      >
        <Icon name="snap" />
      </Toggle>
      <span class={snapping.value ? "snap-step" : "snap-step off"}>
        <NumberField
          label="Snap step"
          value={snapDistance.value}
          unit={unit.value}
          step={snapDistance.value / 10}
          disabled={!mesh.value}
          context="step of a drag"
          onApply={(value) => {
            if (value > 0) snapStep.value = value;
          }}
        />
        <span class="unit">{unit.value}</span>
      </span>
    </>
  );
}

function PinTool() {
  return (
    <Toggle
      name="Pin selected points"
      about={!baseFlat.value ? FLAT_FIRST : "pinned points do not move (P)"}
      on={allPinned()}
      disabled={selection.value.length === 0 || !ready.value || !baseFlat.value}
      onClick={togglePins}
    >
      <Icon name="pin" />
    </Toggle>
  );
}

export function DragTools() {
  return (
    <div
      class={selection.value.length > 0 || boxTool.value ? "drag-tools" : "drag-tools resting"}
      role="toolbar"
      aria-label="Drag tools"
    >
      <Toggle
        name="Select in a box"
        about="the next drag selects the points in a box; with Shift, adds them"
        on={boxTool.value}
        disabled={!ready.value}
        onClick={() => {
          boxTool.value = !boxTool.value;
        }}
      >
        <Icon name="selectBox" />
      </Toggle>
      <PinTool />
      <span class="tool-gap" />
      <LockTools />
      <Toggle
        name="Local arrows"
        about="arrows follow the surface at the point instead of X, Y and Z"
        on={localArrows.value}
        onClick={() => {
          localArrows.value = !localArrows.value;
        }}
      >
        <Icon name="local" />
      </Toggle>
      <span class="tool-gap" />
      <SnapTools />
    </div>
  );
}

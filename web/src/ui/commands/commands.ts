// SPDX-License-Identifier: MIT
// The commands that have a key or a button which is always there. Keys, buttons, Help and the palette
// read this table, and what features add to it; those that later parts and the palette have beside it are in
// more-commands.ts and all-commands.ts.
import type { ViewName } from "../../scene/framing.ts";
import type { Viewport } from "../../scene/viewport.ts";
import { FLAT_FIRST, toggleLock, togglePins } from "../../state/dragging.ts";
import { redo, undo } from "../../state/editing.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import type { Lock } from "../../state/page-state.ts";
import { selectHandles } from "../../state/selection.ts";
import { takeSnapshot } from "../../state/snapshots.ts";
import { pickAndOpen } from "../pick-file.ts";
import { viewOf } from "../view-slot.ts";
import { type Command, notReady, onlyLookedAt } from "./command.ts";
import { paletteDoor } from "./doors.ts";
import { commandGroups } from "./offered-commands.ts";

type Arrow = readonly [right: number, down: number];

const ARROWS: Readonly<Record<string, Arrow>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

/** Four keys, which do something in four directions. */
const byArrows = (
  label: string,
  before: "" | "Ctrl+" | "Shift+",
  act: (view: Viewport, right: number, down: number) => void,
): Command => ({
  label,
  keys: Object.keys(ARROWS).map((arrow) => before + arrow),
  heard: "arrows",
  unlisted: true,
  run: (page, key) => {
    const view = viewOf(page);
    const [right, down] = ARROWS[key.slice(before.length)] ?? [0, 0];
    if (view) act(view, right, down);
  },
});

const inView = (
  label: string,
  keys: readonly string[],
  act: (view: Viewport) => void,
): Command => ({
  label,
  keys,
  heard: "view",
  run: (page) => {
    const view = viewOf(page);
    if (view) act(view);
  },
});

const named = (name: ViewName, key: string): Command =>
  inView(name, [key], (view) => view.view(name));

/** A drag that is free of the usual line has Alt held. */
const withAlt = (...keys: readonly string[]): string[] => [...keys, ...keys.map((k) => `Alt+${k}`)];

const lockTo = (axis: Lock["axis"], name: string, key: string, plane = false): Command => ({
  label: `Lock to ${plane ? "the plane across " : ""}${name}`,
  keys: withAlt(plane ? `Shift+${key}` : key),
  heard: "view",
  run: (page) => toggleLock(page, axis, plane),
});

const AXIS_NAMES = { x: "X", y: "Y", z: "Z" } as const;

const goToRegion = (label: string, key: string, step: 1 | -1): Command => ({
  label,
  keys: [key],
  heard: "everywhere",
  unlisted: true,
  run: () => import("../regions.ts").then((regions) => regions.goToRegion(step)),
});

function cannotPin(page: Page): string {
  if (!page.baseFlat.value) return FLAT_FIRST;
  const chosen = page.selection.value.length > 0;
  return notReady(page) || (chosen ? "" : "No point is selected.");
}

/** A step back or forth under a drag would change what it goes on from. */
const cannotStep = (page: Page): string =>
  onlyLookedAt(page) || (page.pull.value ? "A point is being moved: let go of it first." : "");

/** By id. */
export const COMMANDS = {
  open: { label: "Open file", keys: ["Ctrl+O"], refusal: notReady, run: pickAndOpen },
  save: {
    label: "Save the design",
    keys: ["Ctrl+S"],
    heard: "everywhere",
    refusal: notReady,
    run: async (page) =>
      (await fetchPart(page, () => import("../../export/exporting.ts")))?.exportDesign(page),
  },
  undo: {
    label: "Undo",
    keys: ["Ctrl+Z"],
    refusal: (page) => cannotStep(page) || (page.canUndo.value ? "" : "There is nothing to undo."),
    run: undo,
  },
  redo: {
    label: "Redo",
    keys: ["Ctrl+Shift+Z", "Ctrl+Y"],
    refusal: (page) => cannotStep(page) || (page.canRedo.value ? "" : "There is nothing to redo."),
    run: redo,
  },
  palette: {
    label: "All commands",
    keys: ["Ctrl+K"],
    heard: "everywhere",
    unlisted: true,
    refusal: onlyLookedAt,
    run: (page) => paletteDoor(page).open(),
  },
  takeSnapshot: { label: "Take snapshot", refusal: notReady, run: (page) => takeSnapshot(page) },
  before: {
    label: "Before the edit",
    keys: ["B"],
    heard: "view",
    run: (page) => {
      page.showBefore.value = !page.showBefore.value;
    },
    release: (page) => {
      page.showBefore.value = false;
    },
  },
  nextRegion: goToRegion("Next region", "F6", 1),
  previousRegion: goToRegion("Region before", "Shift+F6", -1),
  selectHandles: {
    label: "Select all handles",
    keys: ["Ctrl+A"],
    heard: "view",
    run: selectHandles,
  },
  pin: {
    label: "Pin selected points",
    keys: ["P"],
    heard: "view",
    refusal: cannotPin,
    run: togglePins,
  },
  moveBy: {
    label: "Move by an amount",
    keys: ["M"],
    heard: "view",
    refusal: cannotPin,
    run: (page) => {
      const { axis, plane } = page.lock.value ?? { axis: "z", plane: false };
      page.typedMove.value = plane || axis === "normal" ? "Z" : AXIS_NAMES[axis];
    },
  },
  lockX: lockTo("x", "X", "X"),
  lockY: lockTo("y", "Y", "Y"),
  lockZ: lockTo("z", "Z", "Z"),
  lockNormal: lockTo("normal", "normal", "N"),
  lockAcrossX: lockTo("x", "X", "X", true),
  lockAcrossY: lockTo("y", "Y", "Y", true),
  lockAcrossZ: lockTo("z", "Z", "Z", true),
  lockAcrossNormal: lockTo("normal", "normal", "N", true),
  perspective: named("Perspective", "1"),
  top: named("Top", "2"),
  front: named("Front", "3"),
  side: named("Side", "4"),
  fit: inView("Fit the selection", ["F"], (view) => view.fit(false)),
  fitAll: inView("Fit all", ["Shift+F"], (view) => view.fit(true)),
  zoomIn: inView("Zoom in", ["+", "="], (view) => view.zoom(0.88)),
  zoomOut: inView("Zoom out", ["-"], (view) => view.zoom(1 / 0.88)),
  giveUp: inView("Clear the selection", withAlt("Escape", "Shift+Escape"), (view) => view.escape()),
  step: byArrows("Step to a point", "", (view, right, down) =>
    view.stepSelection(right, down, false),
  ),
  stepAdding: byArrows("Step to a point and add it", "Ctrl+", (view, right, down) =>
    view.stepSelection(right, down, true),
  ),
  turn: byArrows("Turn the view", "Shift+", (view, right, down) => view.turn(right, down)),
} satisfies Readonly<Record<string, Command>>;

export type CommandId = keyof typeof COMMANDS;

/** What has a key or a button: of the shell, and of features. */
export const commandsAtOnce = (page: Page): readonly Command[] => [
  ...Object.values(COMMANDS),
  ...commandGroups(page).flatMap((group) => group.of),
];

/** What a key means, as keys.ts spells it. */
export const commandOf = (page: Page, key: string): Command | undefined =>
  commandsAtOnce(page).find(({ keys }) => keys?.includes(key));

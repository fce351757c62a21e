// SPDX-License-Identifier: MIT
// The commands that have a key or a button which is always there. Keys, buttons, Help and the palette
// read this table; those that later parts and the palette have beside it are in more-commands.ts and
// all-commands.ts.
import type { ViewName } from "../../scene/framing.ts";
import type { Viewport } from "../../scene/viewport.ts";
import { FLAT_FIRST, toggleLock, togglePins } from "../../state/dragging.ts";
import { redo, undo } from "../../state/editing.ts";
import { hiddenPanels } from "../../state/hidden-panels.ts";
import { goToTab } from "../../state/inspector.ts";
import { fetchPart } from "../../state/later.ts";
import type { Page } from "../../state/page.ts";
import type { Lock } from "../../state/page-state.ts";
import { selectHandles } from "../../state/selection.ts";
import { takeSnapshot } from "../../state/snapshots.ts";
import { pickAndOpen } from "../pick-file.ts";
import { viewOf } from "../view-slot.ts";
import { type Command, notReady, onlyLookedAt } from "./command.ts";
import { type Door, openDoor } from "./doors.ts";

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

type Hiding = typeof import("../../features/hiding/hiding.ts");

const hiding = (
  name: string,
  label: string,
  key: string,
  refusal: (page: Page) => string,
  act: (part: Hiding, page: Page) => void,
): Command => ({
  name,
  label,
  keys: [key],
  heard: "view",
  refusal,
  run: async (page) => {
    const part = await fetchPart(page, () => import("../../features/hiding/hiding.ts"));
    if (part) act(part, page);
  },
});

/** A drag that is free of the usual line has Alt held. */
const withAlt = (...keys: readonly string[]): string[] => [...keys, ...keys.map((k) => `Alt+${k}`)];

const lockTo = (axis: Lock["axis"], name: string, key: string, plane = false): Command => ({
  label: `Lock to ${plane ? "the plane across " : ""}${name}`,
  keys: withAlt(plane ? `Shift+${key}` : key),
  heard: "view",
  run: (page) => toggleLock(page, axis, plane),
});

const AXIS_NAMES = { x: "X", y: "Y", z: "Z" } as const;

const door = (label: string, name: Door, more: Partial<Command> = {}): Command => ({
  label,
  run: (page) => openDoor(page, name),
  ...more,
});

const goToRegion = (label: string, key: string, step: 1 | -1): Command => ({
  label,
  keys: [key],
  heard: "everywhere",
  unlisted: true,
  run: () => import("../regions.ts").then((regions) => regions.goToRegion(step)),
});

const exploring = (page: Page) =>
  fetchPart(page, () => import("../../features/exploring/exploring.ts"));

const findingVariations = (page: Page) =>
  fetchPart(page, () => import("../../features/exploring/gallery.ts"));

function cannotExplore(page: Page): string {
  const moved = page.figures.value.movedVertices > 0;
  return notReady(page) || (moved ? "" : "There is no edit to vary: move a point first.");
}

function cannotPin(page: Page): string {
  if (!page.baseFlat.value) return FLAT_FIRST;
  const chosen = page.selection.value.length > 0;
  return notReady(page) || (chosen ? "" : "No point is selected.");
}

const cannotCut = (page: Page): string => notReady(page) || (page.baseFlat.value ? "" : FLAT_FIRST);

const noPanel = (page: Page): string =>
  page.selection.value.length > 0 || page.selectedPanel.value !== null
    ? ""
    : "No point or panel is selected.";

const nothingHidden = (page: Page): string =>
  hiddenPanels(page).value.size > 0 ? "" : "No panel is hidden.";

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
  share: door("Share", "share", { refusal: notReady }),
  help: door("Help", "help"),
  palette: door("All commands", "palette", {
    keys: ["Ctrl+K"],
    heard: "everywhere",
    unlisted: true,
    refusal: onlyLookedAt,
  }),
  findVariations: {
    label: "Find variations",
    refusal: cannotExplore,
    run: async (page) => (await findingVariations(page))?.findVariations(page),
  },
  makeExact: {
    label: "Make exact",
    refusal: notReady,
    run: async (page) => {
      goToTab(page, "check");
      await (await exploring(page))?.makeExact(page);
    },
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
  cut: {
    label: "Cut panels",
    keys: ["K"],
    heard: "view",
    refusal: cannotCut,
    run: (page: Page) => {
      page.cutting.value = !page.cutting.value;
    },
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
  hide: hiding("Hide", "Hide the selected panels", "H", noPanel, (part, page) =>
    part.hideSelected(page),
  ),
  isolate: hiding("Isolate", "Show only the selected panels", "I", noPanel, (part, page) =>
    part.isolateSelected(page),
  ),
  showAll: hiding("Show all", "Show all panels", "Shift+H", nothingHidden, (part, page) =>
    part.showAll(page),
  ),
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

const ALL: readonly Command[] = Object.values(COMMANDS);

/** What a key means, as keys.ts spells it. */
export const commandOf = (key: string): Command | undefined =>
  ALL.find(({ keys }) => keys?.includes(key));

// SPDX-License-Identifier: MIT
// The keys of the page in Help: which they are, the table of commands says.

import { namesOfFormats } from "../../solver/file-formats.ts";
import type { Page } from "../../state/page.ts";
import type { Command } from "../../ui/commands/command.ts";
import { COMMANDS, type CommandId } from "../../ui/commands/commands.ts";
import { type CommandGroup, commandGroups } from "../../ui/commands/offered-commands.ts";
import { usePage } from "../../ui/page-context.ts";

interface KeyHint {
  readonly of: readonly CommandId[];
  readonly what: string;
}

/** Every command of the shell that has a key is in one of them. */
const KEY_HINTS: readonly KeyHint[] = [
  { of: ["palette"], what: "all commands: type a few letters of one" },
  {
    of: ["lockX", "lockY", "lockZ", "lockNormal"],
    what: "hold drags to an axis or to the normal until pressed again; pressed during a drag, that drag alone",
  },
  {
    of: ["lockAcrossX", "lockAcrossY", "lockAcrossZ", "lockAcrossNormal"],
    what: "hold drags to the plane across",
  },
  { of: ["pin"], what: "pins the selected points, or lets them go" },
  { of: ["moveBy"], what: "moves the selected points by an amount that is typed" },
  { of: ["step"], what: "step from point to point" },
  { of: ["stepAdding"], what: "the same, and add the next point to the selection" },
  { of: ["selectHandles"], what: "selects all handles" },
  { of: ["turn"], what: "turn the view" },
  { of: ["zoomIn", "zoomOut"], what: "zoom" },
  {
    of: ["perspective", "top", "front", "side"],
    what: "perspective; top, front, side in parallel",
  },
  { of: ["fit", "fitAll"], what: "fit what is selected, or all of the model, into the view" },
  { of: ["before"], what: "held, shows the design before the edit" },
  {
    of: ["nextRegion", "previousRegion"],
    what: "go from the bar to the view to the inspector, and back",
  },
  {
    of: ["giveUp"],
    what: "gives up a drag, or a cut that was begun; otherwise clears the selection",
  },
  { of: ["undo", "redo"], what: "undo, redo" },
  {
    of: ["open"],
    what: `opens a mesh (${namesOfFormats("3dm")}) or a design (GLB, 3DM, JSON)`,
  },
  { of: ["save"], what: "saves the design as a file that opens again (JSON)" },
];

/** The commands of the shell that have keys, then those of features. */
export const keyGroups = (page: Page): readonly CommandGroup[] => [
  ...KEY_HINTS.map(({ of, what }) => ({ of: of.map((id) => COMMANDS[id]), keysDo: what })),
  ...commandGroups(page).filter(({ keysDo }) => keysDo),
];

const NAMES: Readonly<Record<string, string>> = {
  ArrowLeft: "←",
  ArrowRight: "→",
  ArrowUp: "↑",
  ArrowDown: "↓",
  Escape: "Esc",
  "-": "−",
};

/** The keys that are said of a command: one, or of those with the arrows all four. */
function saidOf({ keys = [] }: Command): readonly string[] {
  const arrows = keys.filter((key) => key.includes("Arrow"));
  return arrows.length > 0 ? arrows : keys.slice(0, 1);
}

/** "[Ctrl] [Z], [Ctrl] [Shift] [Z]"; keys with the same keys held are said together: "[Shift] [X] [Y]". */
export function keysOf(commands: readonly Command[]): string {
  let before: string | null = null;
  let words = "";
  for (const key of commands.flatMap(saidOf)) {
    const parts = key.split(/\+(?=.)/);
    const name = parts.pop() ?? "";
    const held = parts.map((part) => `[${part}] `).join("");
    words += held === before ? " " : `${before === null ? "" : ", "}${held}`;
    words += `[${NAMES[name] ?? name}]`;
    before = held;
  }
  return words;
}

/** Words, with names of keys as keys. */
export function Keys({ text }: { text: string }) {
  return (
    <>
      {text
        .split(/\[(.+?)\]/)
        .map((part, k) => (k % 2 === 1 ? <kbd key={part}>{part}</kbd> : part))}
    </>
  );
}

export function HelpKeys() {
  return (
    <>
      {keyGroups(usePage()).map(({ of, keysDo }) => (
        <div key={keysDo}>
          <dt>
            <Keys text={keysOf(of)} />
          </dt>
          <dd>{keysDo}</dd>
        </div>
      ))}
    </>
  );
}

/** The way to the palette without keys. */
export function AllCommands() {
  const page = usePage();
  return (
    <button
      type="button"
      class="button small"
      onClick={({ currentTarget }) => {
        currentTarget.closest("dialog")?.close();
        COMMANDS.palette.run(page);
      }}
    >
      {COMMANDS.palette.label}
    </button>
  );
}

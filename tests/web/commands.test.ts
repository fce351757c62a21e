// SPDX-License-Identifier: MIT
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { registerFeatures } from "../../web/src/features/all-features.ts";
import { CUT } from "../../web/src/features/cut/cut-button.tsx";
import { EXPLORING_COMMANDS } from "../../web/src/features/exploring/exploring-commands.ts";
import { keyGroups, keysOf } from "../../web/src/features/help/help-keys.tsx";
import { found } from "../../web/src/features/palette/command-palette.tsx";
import { SELECTION_COMMANDS } from "../../web/src/features/selecting/selection-commands.ts";
import { SHARE } from "../../web/src/features/sharing/share-dialog.tsx";
import type { Page } from "../../web/src/state/page.ts";
import { allCommands } from "../../web/src/ui/commands/all-commands.ts";
import { type Command, keyOf, refusalOf, titleOf } from "../../web/src/ui/commands/command.ts";
import {
  COMMANDS,
  type CommandId,
  commandOf,
  commandsAtOnce,
} from "../../web/src/ui/commands/commands.ts";
import { spelled } from "../../web/src/ui/commands/keys.ts";
import { MORE_COMMANDS } from "../../web/src/ui/commands/more-commands.ts";
import { laterCommands } from "../../web/src/ui/commands/offered-commands.ts";
import { openedPage, pageAlone, pageHere } from "./support/page-here.ts";

/** With every feature. */
function registered(page: Page): Page {
  registerFeatures(page);
  return page;
}

/** Where each command is looked up; what it is done to is another page. */
const SHELF = registered(pageAlone());

const ALL_COMMANDS = allCommands(
  SHELF,
  (await Promise.all(laterCommands(SHELF).map((list) => list()))).flat(),
);

const labels = (commands: readonly Command[]): string[] => commands.map(({ label }) => label);

const pressed = (key: string, held: Partial<KeyboardEvent> = {}): string =>
  spelled({
    key,
    ctrlKey: false,
    metaKey: false,
    altKey: false,
    shiftKey: false,
    ...held,
  } as KeyboardEvent);

describe("the table", () => {
  it("gives no key two meanings", () => {
    const keys = ALL_COMMANDS.flatMap(({ keys = [] }) => keys);
    expect(keys.length).toBeGreaterThan(40);
    expect(keys.filter((key, k) => keys.indexOf(key) !== k)).toEqual([]);
  });

  it("has a label for every command, and no label twice", () => {
    const all = labels(ALL_COMMANDS);
    expect(all.filter((label, k) => label === "" || all.indexOf(label) !== k)).toEqual([]);
  });

  it("says why a command cannot run, in a sentence", async () => {
    const looking = await openedPage();
    looking.readOnly.value = true;
    for (const page of [pageAlone(), pageHere(), await openedPage(), looking]) {
      const refused = ALL_COMMANDS.map((command) => refusalOf(page, command)).filter(Boolean);
      expect(refused.length).toBeGreaterThan(2);
      for (const why of refused) expect(why).toMatch(/^[A-Z].+\.$/);
    }
    expect(refusalOf(looking, COMMANDS.undo)).toBe("This design can only be looked at.");
    expect(titleOf(looking, COMMANDS.top)).toBe("Top (2)");
  });

  it("is where Help has its keys from: each command with a key is in one hint", () => {
    const said = keyGroups(SHELF).flatMap(({ of }) => of);
    const withKeys = commandsAtOnce(SHELF).filter(({ keys }) => keys);
    expect(withKeys).toContain(CUT);
    expect(labels(said).sort()).toEqual(labels(withKeys).sort());
    expect(keysOf([COMMANDS.undo, COMMANDS.redo])).toBe("[Ctrl] [Z], [Ctrl] [Shift] [Z]");
    expect(keysOf([COMMANDS.lockAcrossX, COMMANDS.lockAcrossY])).toBe("[Shift] [X] [Y]");
    expect(keysOf([COMMANDS.step])).toBe("[←] [→] [↑] [↓]");
  });
});

it("keys are spelled as the table has them", () => {
  const at = (id: CommandId): Command => COMMANDS[id];
  expect(commandOf(SHELF, pressed("z", { ctrlKey: true }))).toBe(at("undo"));
  expect(commandOf(SHELF, pressed("Z", { metaKey: true, shiftKey: true }))).toBe(at("redo"));
  expect(commandOf(SHELF, pressed("+", { shiftKey: true }))).toBe(at("zoomIn"));
  expect(commandOf(SHELF, pressed("1", { shiftKey: true }))).toBe(at("perspective"));
  expect(commandOf(SHELF, pressed("X", { shiftKey: true, altKey: true }))).toBe(at("lockAcrossX"));
  expect(commandOf(SHELF, pressed("Escape", { shiftKey: true }))).toBe(at("giveUp"));
  expect(commandOf(SHELF, pressed("ArrowLeft", { ctrlKey: true }))).toBe(at("stepAdding"));
  expect(commandOf(SHELF, pressed("b", { altKey: true }))).toBeUndefined();
  expect(commandOf(SHELF, pressed("x", { ctrlKey: true }))).toBeUndefined();
  expect(keyOf(COMMANDS.redo)).toBe("Ctrl Shift Z");
  expect(keyOf(SHARE)).toBe("");
});

it("a few letters find a command, those that begin with them first", () => {
  const find = (typed: string): readonly Command[] => found(typed, ALL_COMMANDS);
  expect(labels(find("export o"))[0]).toBe("Export OBJ");
  expect(labels(find("undo"))).toEqual(["Undo"]);
  expect(labels(find("by colour fold"))).toEqual(["Colour by folds"]);
  expect(find("nothing is called so")).toEqual([]);
  expect(find("").length).toBeGreaterThan(40);
});

describe("without a browser", () => {
  /** As much of a document as commands use: a picked file is none. */
  const element = () => ({
    addEventListener: (name: string, listener: () => void) => {
      if (name === "cancel") setTimeout(listener);
    },
    click: () => {},
  });
  beforeEach(() => {
    vi.stubGlobal("document", {
      createElement: element,
      querySelector: () => null,
      querySelectorAll: () => [],
      getElementById: () => null,
    });
  });
  afterEach(() => {
    vi.unstubAllGlobals();
  });

  it.each(ALL_COMMANDS.map((command) => [command.label, command] as const))(
    "%s runs",
    async (_, command) => {
      const page = await openedPage();
      const before = page.history.value;
      if (refusalOf(page, command)) {
        page.selection.value = [220, 221];
        await MORE_COMMANDS.addHandle.run(page);
      }
      for (const key of command.keys ?? [""]) await command.run(page, key);
      expect(page.mesh.value).not.toBeNull();
      expect(page.history.value).not.toBeNull();
      expect(before).not.toBeNull();
    },
  );

  it("selected points are pinned, freed and let go of, or it is said why not", async () => {
    const page = await openedPage();
    const { pinSelected, freeSelected, removeSelected } = SELECTION_COMMANDS;
    const refusals = (): string[] =>
      [pinSelected, freeSelected, removeSelected].map((command) => refusalOf(page, command));
    expect(refusals()).toEqual(Array(3).fill("No point is selected."));
    page.selection.value = [220, 221];
    expect(refusals()).toEqual(["", "None of them is pinned.", "None of them has a handle."]);
    expect(titleOf(page, freeSelected, "lets them go")).toBe(
      "Free the selected points: None of them is pinned.",
    );
    expect(titleOf(page, pinSelected, "they stay")).toBe("Pin all selected points: they stay");
    await pinSelected.run(page);
    expect(page.handles.value.map(({ vertex, pinned }) => [vertex, pinned])).toEqual([
      [220, true],
      [221, true],
    ]);
    expect(refusals()).toEqual(["All of them are pinned.", "", ""]);
    await freeSelected.run(page);
    expect(page.handles.value).toEqual([]);
    await pinSelected.run(page);
    page.selection.value = [221];
    await removeSelected.run(page);
    expect(page.handles.value.map(({ vertex }) => vertex)).toEqual([220]);
  });

  it("an exact design is said to be so, and stays", async () => {
    const page = await openedPage();
    const before = page.history.value;
    await EXPLORING_COMMANDS.makeExact.run(page);
    expect(page.notice.value).toBe("Already exact: every panel is flat.");
    expect(page.history.value).toBe(before);
    // Who asks again hears it again: the words are other ones, and look the same.
    await EXPLORING_COMMANDS.makeExact.run(page);
    expect(page.notice.value).toBe("Already exact: every panel is flat.\u00a0");
    await EXPLORING_COMMANDS.makeExact.run(page);
    expect(page.notice.value).toBe("Already exact: every panel is flat.");
  });

  it("what a key does is done", async () => {
    const page: Page = await openedPage();
    commandOf(SHELF, "Shift+X")?.run(page, "Shift+X");
    expect(page.lock.value).toEqual({ axis: "x", plane: true });
    commandOf(SHELF, "B")?.run(page, "B");
    expect(page.showBefore.value).toBe(true);
    commandOf(SHELF, "B")?.release?.(page);
    expect(page.showBefore.value).toBe(false);
    SELECTION_COMMANDS.selectBoundary.run(page);
    expect(page.selection.value.length).toBeGreaterThan(10);
  });
});

// SPDX-License-Identifier: MIT
// Needs: workers, storage.
// Long random sequences of what a user can do, against a model that lives outside the page. After
// every action: the page's file is the model's to the last digit, every panel is flat, what is not
// counted as moved has its old digits, and the status line says what the file says.
// PLANISH_ACTIONS sets how many actions each seed makes, PLANISH_SEED adds a seed; every night they are long.
import type { Page } from "playwright-core";
import { expect, it } from "vitest";
import { NIGHTLY } from "../patience.ts";
import { randomFrom } from "../web/support/mutations.ts";
import { flatRoof } from "./support/faults.ts";
import { catchExports, Hands } from "./support/hands.ts";
import { type Entry, Journal } from "./support/journal.ts";
import { type ObjMesh, readObj, worstFlatness } from "./support/obj.ts";
import { kept, openFile, usable } from "./support/page.ts";
import { site } from "./support/site.ts";

const ACTIONS = Number(process.env.PLANISH_ACTIONS ?? (NIGHTLY ? 75 : 12));
const SEEDS = [
  1,
  ...(NIGHTLY ? [2] : []),
  ...(process.env.PLANISH_SEED ? [Number(process.env.PLANISH_SEED)] : []),
];
const TOLERANCE = 1e-6;

const SAMPLES = ["vault", "dome", "freeform", "hex", "trihex"];
const BENT = "v 0 0 0\nv 2 0 0\nv 2 2 0.3\nv 0 2 0\nv 4 0 0\nv 4 2 0\nf 1 2 3 4\nf 2 5 6 3\n";

/** `records`: what the action does to the journal if it is not refused. */
interface Action {
  readonly name: string;
  readonly act: () => Promise<void>;
  readonly records: "step" | "opened" | "undo" | "redo" | "nothing";
  readonly flat?: boolean;
}

class Visitor {
  readonly #page: Page;
  readonly #hands: Hands;
  readonly #random: () => number;
  #journal: Journal;
  #snapshots = new Map<string, Entry>();
  readonly log: string[] = [];

  constructor(page: Page, hands: Hands, seed: number, first: string) {
    this.#page = page;
    this.#hands = hands;
    this.#random = randomFrom(seed);
    this.#journal = new Journal({ obj: first, base: first, flat: true });
  }

  #below(count: number): number {
    return Math.floor(this.#random() * count);
  }

  #pick<T>(choices: readonly T[]): T {
    const chosen = choices[this.#below(choices.length)];
    if (chosen === undefined) throw new Error("nothing to choose from");
    return chosen;
  }

  /** Chooses among what the page offers now, acts, and checks. */
  async goOn(): Promise<void> {
    const action = this.#pick(await this.#choices());
    this.log.push(action.name);
    const before = this.#journal.present;
    await action.act();
    const obj = await this.#hands.obj();
    const refused = action.records === "undo" ? "" : await this.#hands.alert();
    if (action.records === "undo") this.#journal.undo();
    else if (action.records === "redo") this.#journal.redo();
    else if (action.records === "opened" && !refused)
      this.#journal.step({ obj, base: obj, flat: action.flat ?? true });
    else if (action.records === "step" && !refused) this.#journal.step({ ...before, obj });
    await this.#check(obj);
  }

  async #check(obj: string): Promise<void> {
    const { present } = this.#journal;
    const told = this.log.slice(-12).join(" → ");
    expect(obj === present.obj, `${told}: the file is not the journal's`).toBe(true);
    const buttons = await this.#hands.names("button");
    expect([buttons.includes("Undo"), buttons.includes("Redo")], told).toEqual([
      this.#journal.canUndo,
      this.#journal.canRedo,
    ]);
    const [mesh, base] = [readObj(obj), readObj(present.base)];
    if (present.flat) expect(worstFlatness(mesh), told).toBeLessThan(TOLERANCE);
    const { moved, largest } = difference(mesh, base);
    const status = await this.#hands.status();
    expect(status, told).toContain(`${moved} of ${mesh.lines.length} points move`);
    const [, figure = "", unit] = /largest ([\d.]+) (mm|m)/.exec(status) ?? [];
    const digits = figure.includes(".") ? figure.split(".")[1]?.length : 0;
    const shown = unit === "m" ? largest : 1000 * largest;
    expect(Math.abs(Number(figure) - shown), told).toBeLessThanOrEqual(0.51 * 10 ** -(digits ?? 0));
    if (present.flat) expect(status, told).toContain("worst panel 0.0000 mm");
  }

  async #choices(): Promise<Action[]> {
    const buttons = await this.#hands.names("button");
    const has = (name: string): boolean => buttons.includes(name);
    const always: Action[] = [this.#opening(), this.#snapshot()];
    if (has("Undo")) always.push(...this.#pressing("Undo", "undo", 3));
    if (has("Redo")) always.push(...this.#pressing("Redo", "redo", 3));
    if (this.#random() < 0.05) always.push(this.#reload());
    const snapshots = this.#adoptions(buttons);
    if (!this.#journal.present.flat)
      return [...always, ...snapshots, ...this.#pressing("Planarise", "opened", 4)];
    return [...always, ...snapshots, ...(await this.#edits(buttons))];
  }

  #pressing(name: string, records: Action["records"], weight = 1): Action[] {
    const action = { name, records, act: () => this.#hands.press(name) };
    return Array.from({ length: weight }, () => action);
  }

  #opening(): Action {
    const kind = this.#pick(["sample", "roof", "bent"] as const);
    if (kind === "sample") {
      const name = this.#pick(SAMPLES);
      const act = () => this.#hands.fill("combobox", "Sample", name);
      return { name: `sample ${name}`, records: "opened", act };
    }
    const size = 4 + this.#below(8);
    const content = kind === "roof" ? flatRoof(size) : BENT;
    const act = async () => {
      await openFile(this.#page, `${kind}.obj`, content);
      const close = kind === "roof" ? "Start editing" : "Not now";
      // The report comes in a part of the page that loads when first asked for.
      await this.#page.getByRole("button", { name: close }).waitFor();
      await this.#hands.press(close);
    };
    return { name: `open ${kind}`, records: "opened", flat: kind === "roof", act };
  }

  #snapshot(): Action {
    const act = async () => {
      const before = new Set(await this.#hands.names("button"));
      await this.#hands.press("Take snapshot");
      for (const name of await this.#hands.names("button")) {
        if (name.startsWith("Adopt Snapshot") && !before.has(name))
          this.#snapshots.set(name, this.#journal.present);
      }
    };
    return { name: "take snapshot", records: "nothing", act };
  }

  #adoptions(buttons: readonly string[]): Action[] {
    const actions: Action[] = [];
    for (const name of buttons.filter((button) => button.startsWith("Adopt Snapshot"))) {
      const entry = this.#snapshots.get(name);
      if (!entry) continue;
      actions.push({ name, records: "nothing", act: () => this.#adopt(name, entry) });
      const drop = name.replace("Adopt", "Delete");
      actions.push({ name: drop, records: "nothing", act: () => this.#drop(drop, name) });
    }
    return actions.slice(0, 3);
  }

  async #adopt(name: string, entry: Entry): Promise<void> {
    await this.#hands.press(name);
    this.#journal.step(entry);
  }

  async #drop(name: string, adopt: string): Promise<void> {
    await this.#hands.press(name);
    this.#snapshots.delete(adopt);
  }

  #reload(): Action {
    const act = async () => {
      await kept(this.#page);
      await this.#page.reload();
      await usable(this.#page);
      await this.#hands.settle();
      this.#journal.forget();
    };
    return { name: "reload", records: "nothing", act };
  }

  async #edits(buttons: readonly string[]): Promise<Action[]> {
    const actions: Action[] = [...this.#pressing("Add handle", "step")];
    const rows = (await this.#hands.names("spinbutton")).filter((name) => name === "Z").length;
    if (rows > 0) {
      for (let k = 0; k < 6; ++k) actions.push(this.#move(this.#below(rows)));
      const row = this.#below(rows);
      const toggle = () => this.#hands.toggle("Pinned", row);
      actions.push({ name: "pin or unpin", records: "step", act: toggle });
      const remove = buttons.find((name) => /^Remove/.test(name));
      if (remove) actions.push(...this.#pressing(remove, "step"));
    }
    actions.push(this.#slider("Reach", 12), this.#slider("Softness", 10));
    if (buttons.includes("Find variations")) actions.push(...this.#exploring(buttons));
    if (buttons.includes("Continue from this shape"))
      actions.push(...this.#pressing("Continue from this shape", "opened"));
    return [...actions, ...(await this.#varying(buttons))];
  }

  #move(row: number): Action {
    const axis = this.#pick(["X", "Y", "Z", "Z"]);
    const by = (this.#below(2) ? 1 : -1) * (1 + this.#below(40));
    const text = by > 0 ? `+${by}cm` : `+-${-by}cm`;
    const act = () => this.#hands.fill("spinbutton", axis, text, row);
    return { name: `${axis} ${text}`, records: "step", act };
  }

  #slider(name: string, most: number): Action {
    const value = String(1 + this.#below(most));
    const act = () => this.#hands.fill("slider", name, value);
    return { name: `${name} ${value}`, records: "step", act };
  }

  #exploring(buttons: readonly string[]): Action[] {
    const actions: Action[] = [...this.#pressing("Find variations", "step", 2)];
    // Whatever came before left an exact design.
    if (buttons.includes("Make exact")) actions.push(...this.#pressing("Make exact", "nothing"));
    return actions;
  }

  /** Cancelled in time it is no step; a step that was faster shows sliders. */
  #cancelling(): Action {
    const after = this.#below(120);
    const act = async () => {
      await this.#hands.pressAndCancel("Find variations", after);
      if (await this.#hasSliders()) this.#journal.step({ ...this.#journal.present });
    };
    return { name: `find variations, cancel after ${after} ms`, records: "nothing", act };
  }

  async #sliders(): Promise<string[]> {
    return (await this.#hands.names("slider")).filter((name) => /^Variation/.test(name));
  }

  async #hasSliders(): Promise<boolean> {
    return (await this.#sliders()).length > 0;
  }

  async #varying(buttons: readonly string[]): Promise<Action[]> {
    const sliders = await this.#sliders();
    if (sliders.length === 0)
      return buttons.includes("Find variations") ? [this.#cancelling()] : [];
    const slider = this.#pick(sliders);
    const value = String((this.#below(181) - 90) / 100);
    const slide = () => this.#hands.fill("slider", slider, value);
    const tiles = buttons.filter((name) => /^Adopt design/.test(name));
    const adopt = tiles.length > 0 ? this.#pressing(this.#pick(tiles), "step", 2) : [];
    return [{ name: `${slider} ${value}`, records: "step", act: slide }, ...adopt];
  }
}

function difference(mesh: ObjMesh, base: ObjMesh): { moved: number; largest: number } {
  let [moved, largest] = [0, 0];
  mesh.lines.forEach((line, v) => {
    if (line === base.lines[v]) return;
    moved += 1;
    const [a = [], b = []] = [mesh.points[v], base.points[v]];
    largest = Math.max(largest, Math.hypot(...a.map((x, k) => x - (b[k] ?? 0))));
  });
  return { moved, largest };
}

it.each(SEEDS)("seed %i: every action keeps the promises", { timeout: 7_200_000 }, async (seed) => {
  const size = { width: 600, height: 480 };
  const page = await site.open({ viewport: size, reducedMotion: "reduce" }, "", catchExports);
  const hands = new Hands(page);
  const visitor = new Visitor(page, hands, seed, await hands.obj());
  for (let k = 0; k < ACTIONS; ++k) await visitor.goOn();
  await page.context().close();
});

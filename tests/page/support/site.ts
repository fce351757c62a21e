// SPDX-License-Identifier: MIT
// The whole page in this process: its components in a DOM, its solver the wasm core behind the worker's own
// dispatcher, its view WebGL that draws nothing. A visitor is driven by as much of Playwright's API as the
// tests use, so that a test reads the same with and without a browser (tests/browser/support/page.ts).
import { buffer } from "node:stream/consumers";
import type { Page as BrowserPage, Download } from "playwright-core";
import { h, render } from "preact";
import { afterEach, expect } from "vitest";
import { followAddress, openAddress } from "../../../web/src/app/address.ts";
import { App } from "../../../web/src/app/app.tsx";
import { DEFAULT_SETTINGS } from "../../../web/src/design/design.ts";
import { encodeLink } from "../../../web/src/design/link.ts";
import { keepFreedom, keepPanelFigures } from "../../../web/src/state/analysis.ts";
import { loadFigures } from "../../../web/src/state/figures.ts";
import { openFirst } from "../../../web/src/state/opening.ts";
import type { Page } from "../../../web/src/state/page.ts";
import { say } from "../../../web/src/state/telling.ts";
import { PageProvider } from "../../../web/src/ui/page-context.ts";
import { PATIENCE } from "../../patience.ts";
import { pageHere } from "../../web/support/page-here.ts";
import { heldKeys, keyDown, keyUp, pressKey } from "./hands.ts";
import { LocatorHere, turn, until } from "./locator.ts";
import type { Hold } from "./surroundings.ts";

const hold = (): Hold => (globalThis as unknown as { planishHold: Hold }).planishHold;

/** The mouse, over the view alone. */
class Mouse {
  #at = { x: 0, y: 0 };
  #buttons = 0;

  #send(type: string): void {
    const { x: clientX, y: clientY } = this.#at;
    const button = type === "pointermove" ? -1 : 0;
    const pointer = { pointerId: 1, pointerType: "mouse", isPrimary: true };
    const init = { bubbles: true, cancelable: true, clientX, clientY, button, ...heldKeys() };
    const event = new PointerEvent(type, { ...init, ...pointer, buttons: this.#buttons });
    document.querySelector("canvas")?.dispatchEvent(event);
  }

  async move(x: number, y: number): Promise<void> {
    this.#at = { x, y };
    this.#send("pointermove");
    await turn();
  }

  async down(): Promise<void> {
    this.#buttons = 1;
    this.#send("pointerdown");
    await turn();
  }

  async up(): Promise<void> {
    this.#buttons = 0;
    this.#send("pointerup");
    await turn();
  }

  async click(x: number, y: number): Promise<void> {
    await this.move(x, y);
    await this.down();
    await this.up();
  }
}

const keyboard = {
  async press(chord: string): Promise<void> {
    pressKey(chord);
    await turn();
  },
  async down(key: string): Promise<void> {
    keyDown(key);
    await turn();
  },
  async up(key: string): Promise<void> {
    keyUp(key);
    await turn();
  },
  async type(text: string): Promise<void> {
    for (const letter of text) pressKey(letter);
    await turn();
  },
};

/** What the page saved after this. */
async function nextDownload(): Promise<Download> {
  const seen = hold().saved.length;
  const found = await until(
    () => hold().saved[seen] ?? null,
    () => "nothing was saved",
  );
  const { name, blob } = found;
  const createReadStream = async () => blob.stream();
  return { suggestedFilename: () => name, createReadStream } as unknown as Download;
}

interface Given {
  readonly name: string;
  readonly buffer: Buffer;
}

async function nextFileChooser() {
  const seen = hold().asked.length;
  const input = await until(
    () => hold().asked[seen] ?? null,
    () => "no file was asked for",
  );
  return {
    async setFiles({ name, buffer }: Given): Promise<void> {
      const file = new File([new Uint8Array(buffer)], name);
      Object.defineProperty(input, "files", { value: [file], configurable: true });
      input.dispatchEvent(new Event("change", { bubbles: true }));
      await turn();
    },
  };
}

const EVENTS: Readonly<Record<string, () => Promise<unknown>>> = {
  download: nextDownload,
  filechooser: nextFileChooser,
};

/** Fails the test in which the page logs an error. */
const complaints: string[] = [];
console.error = (...said: unknown[]) => complaints.push(said.map(String).join(" "));
window.addEventListener("error", (event) => complaints.push(String(event.message)));
afterEach(() => expect(complaints.splice(0)).toEqual([]));

/** Of the page that is open; another one takes its place. */
let leave = (): void => {};

/** What happens when the page opens, but for what browsers keep. */
async function begin(page: Page): Promise<void> {
  if (!(await openAddress(page))) {
    const said = page.problem.value;
    await openFirst(page);
    say(page, said);
  }
  followAddress(page);
  void loadFigures(page);
}

/** The address of a page that a server would have. */
const ADDRESS = "http://localhost/under/a/path/";

async function openPage(hash: string): Promise<BrowserPage> {
  leave();
  location.href = ADDRESS + hash;
  const page = pageHere();
  page.ready.value = false;
  const root = document.createElement("div");
  root.id = "app";
  document.body.replaceChildren(root);
  render(h(PageProvider, { value: page }, h(App, {})), root);
  keepPanelFigures(page);
  keepFreedom(page);
  leave = () => {
    render(null, root);
    root.remove();
    leave = () => {};
  };
  await begin(page);
  page.ready.value = true;
  await turn();
  const whole = new LocatorHere(() => [document.documentElement], "page");
  const here = {
    keyboard,
    mouse: new Mouse(),
    context: () => ({ close: async () => leave() }),
    evaluate: async (ask: (given: unknown) => unknown, given: unknown) => await ask(given),
    waitForEvent: (name: string) => {
      const next = EVENTS[name];
      if (!next) throw new Error(`tests/page knows no event ${name}`);
      return next();
    },
    waitForTimeout: turn,
    url: () => location.href,
    page,
  };
  return new Proxy(here, {
    get(own, name) {
      if (name in own) return own[name as keyof typeof own];
      const found: unknown = whole[name as keyof LocatorHere];
      if (typeof found === "function") return found.bind(whole);
      if (typeof name === "symbol" || name === "then") return undefined;
      throw new Error(`tests/page knows no page.${name}`);
    },
  }) as unknown as BrowserPage;
}

const VAULT = {
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [],
  settings: DEFAULT_SETTINGS,
  families: [],
  unit: "m",
  camera: null,
  mark: { hash: 0, moved: 0, probes: [] },
} as const;

export const site = {
  url: ADDRESS,
  /** A new visitor; the one before has gone. */
  open: (_options: object = {}, hash = ""): Promise<BrowserPage> => openPage(hash),
  /** A visitor who opens a link to the vault under the raw weights, which nobody has edited. */
  openVault: async (): Promise<BrowserPage> => openPage(await encodeLink(VAULT)),
};
void buffer;
void PATIENCE;

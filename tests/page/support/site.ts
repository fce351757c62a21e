// SPDX-License-Identifier: MIT
// The whole page in this process: its components in a DOM, its solver the wasm core behind the worker's own
// dispatcher, its view WebGL that draws nothing. A visitor is driven by as much of Playwright's API as the
// tests use, so that a test reads the same with and without a browser (tests/browser/support/page.ts).
import { runInThisContext } from "node:vm";
import type { Page as BrowserPage, Download } from "playwright-core";
import { h, render } from "preact";
import { followAddress, openAddress } from "../../../web/src/app/address.ts";
import { App } from "../../../web/src/app/app.tsx";
import { FIRST_SETTINGS } from "../../../web/src/design/design.ts";
import { registerFeatures } from "../../../web/src/features/all-features.ts";
import { keepFreedom, keepPanelFigures } from "../../../web/src/state/analysis.ts";
import { loadFigures } from "../../../web/src/state/figures.ts";
import { openFirst } from "../../../web/src/state/opening.ts";
import type { Page } from "../../../web/src/state/page.ts";
import { say } from "../../../web/src/state/telling.ts";
import { PageProvider } from "../../../web/src/ui/page-context.ts";
import { encodeLink } from "../../web/support/links.ts";
import { endWorkers, pageHere } from "../../web/support/page-here.ts";
import { vault } from "../../web/support/vault.ts";
import { heldKeys, keyDown, keyUp, pressKey } from "./hands.ts";
import { LocatorHere, turn, until } from "./locator.ts";
import type { Hold } from "./surroundings.ts";
import { resizeWindow, type Size } from "./view.ts";

const hold = (): Hold => (globalThis as unknown as { planishHold: Hold }).planishHold;

/** The mouse, over the view alone. */
class Mouse {
  #at = { x: 0, y: 0 };
  #buttons = 0;

  #init() {
    const { x: clientX, y: clientY } = this.#at;
    return { bubbles: true, cancelable: true, clientX, clientY, ...heldKeys() };
  }

  #dispatch(event: Event): void {
    document.querySelector("canvas")?.dispatchEvent(event);
  }

  #send(type: string): void {
    const button = type === "pointermove" ? -1 : 0;
    const pointer = { pointerId: 1, pointerType: "mouse", isPrimary: true };
    const init = { ...this.#init(), button, buttons: this.#buttons };
    this.#dispatch(new PointerEvent(type, { ...init, ...pointer }));
  }

  async move(x: number, y: number, { steps = 1 } = {}): Promise<void> {
    const from = this.#at;
    for (let k = 1; k <= steps; ++k) {
      const share = k / steps;
      this.#at = { x: from.x + (x - from.x) * share, y: from.y + (y - from.y) * share };
      this.#send("pointermove");
      await turn();
    }
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

  async dblclick(x: number, y: number): Promise<void> {
    await this.click(x, y);
    await this.click(x, y);
    this.#dispatch(new MouseEvent("dblclick", this.#init()));
    await turn();
  }

  async wheel(_right: number, deltaY: number): Promise<void> {
    const turned = { deltaX: 0, deltaY, deltaMode: 0 };
    this.#dispatch(Object.assign(new MouseEvent("wheel", this.#init()), turned));
    await turn();
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

interface Listening {
  readonly target: EventTarget;
  readonly given: Parameters<EventTarget["addEventListener"]>;
}

/** A page in this process; only one of them is in the document. */
interface Visitor {
  readonly root: HTMLElement;
  readonly listening: Listening[];
  address: string;
}

let current: Visitor | null = null;

// What a page hears of the window and the document it hears while it is there.
for (const target of [window, document]) {
  const add = target.addEventListener.bind(target);
  target.addEventListener = ((...given: Listening["given"]): void => {
    current?.listening.push({ target, given });
    add.apply(target, given as never);
  }) as typeof target.addEventListener;
}

const setAddress = (url: string): void =>
  (window as unknown as { happyDOM: { setURL(url: string): void } }).happyDOM.setURL(url);

function park(): void {
  if (!current) return;
  const { root, listening } = current;
  current.address = location.href;
  for (const { target, given } of listening)
    target.removeEventListener(given[0], given[1], given[2]);
  root.remove();
  current = null;
}

function show(visitor: Visitor): void {
  if (current === visitor) return;
  park();
  setAddress(visitor.address);
  document.body.append(visitor.root);
  for (const { target, given } of visitor.listening) target.addEventListener(...given);
  current = visitor;
}

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

async function openPage(size: Size, hash: string): Promise<BrowserPage> {
  resizeWindow(size);
  const page = pageHere();
  registerFeatures(page);
  page.ready.value = false;
  const root = document.createElement("div");
  root.id = "app";
  const visitor: Visitor = { root, listening: [], address: ADDRESS + hash };
  show(visitor);
  render(h(PageProvider, { value: page }, h(App, {})), root);
  keepPanelFigures(page);
  keepFreedom(page);
  const leave = (): void => {
    show(visitor);
    render(null, root);
    park();
    endWorkers(page);
  };
  await begin(page);
  page.ready.value = true;
  await turn();
  const whole = new LocatorHere(() => {
    show(visitor);
    return [document.documentElement];
  }, "page");
  const here = {
    keyboard,
    mouse: new Mouse(),
    context: () => ({ close: async () => leave() }),
    evaluate: async (ask: ((given: unknown) => unknown) | string, given: unknown) =>
      typeof ask === "string" ? runInThisContext(ask) : await ask(given),
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
      if (name !== "context" && name !== "then") show(visitor);
      if (name in own) return own[name as keyof typeof own];
      const found: unknown = whole[name as keyof LocatorHere];
      if (typeof found === "function") return found.bind(whole);
      if (typeof name === "symbol" || name === "then") return undefined;
      throw new Error(`tests/page knows no page.${name}`);
    },
  }) as unknown as BrowserPage;
}

/** Half the points of the page's own: most of what a test costs is what it solves. */
const SMALL = 15;

/** What browsers are told of a visitor; of it all the size of the window matters here. */
interface Visit {
  readonly viewport?: Size;
  readonly draws?: boolean;
  readonly permissions?: readonly string[];
  readonly reducedMotion?: "reduce";
}

interface VaultVisit extends Visit {
  readonly size?: number;
}

const DESK = { width: 900, height: 640 };

export const site = {
  url: ADDRESS,
  /** A new visitor; the one before has gone. */
  open: ({ viewport = DESK }: Visit = {}, hash = ""): Promise<BrowserPage> =>
    openPage(viewport, hash),
  /** A visitor who opens a link to a vault under the raw weights, which nobody has edited. */
  openVault: async ({ viewport = DESK, size = SMALL }: VaultVisit = {}): Promise<BrowserPage> =>
    openPage(viewport, await encodeLink(vault(size))),
  /** A visitor who opens a link to a smaller one under the page's own settings: for what is tried in all ways. */
  openSmall: async ({ viewport = DESK }: Visit = {}): Promise<BrowserPage> =>
    openPage(viewport, await encodeLink(vault(11, FIRST_SETTINGS))),
};

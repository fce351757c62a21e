// SPDX-License-Identifier: MIT
// What the page asks of a browser and a DOM alone has not: dialogs above the page, menus that pop over it,
// files that are picked and saved.
import { Blob as NodeBlob, File as NodeFile } from "node:buffer";
import { readFile } from "node:fs/promises";
import * as streams from "node:stream/web";
import { provideView } from "./view.ts";

// Bytes are those of node: streams of a DOM's own blobs do not go through its compression.
Object.assign(globalThis, {
  Blob: NodeBlob,
  File: NodeFile,
  CompressionStream: streams.CompressionStream,
  DecompressionStream: streams.DecompressionStream,
  ReadableStream: streams.ReadableStream,
  WritableStream: streams.WritableStream,
});

provideView();

/** Nobody looks at what the page shows for a while: its pauses take this part of their time. */
const HURRIED = 1 / 8;
let pace = HURRIED;
const { setTimeout: wait } = globalThis;
globalThis.setTimeout = ((act: () => void, milliseconds = 0, ...given: []) =>
  wait(act, milliseconds * pace, ...given)) as typeof setTimeout;

/** In a test of what comes first, a pause or an answer, pauses take all of their time. */
export const setPace = (own: "hurried" | "own"): void => {
  pace = own === "own" ? 1 : HURRIED;
};

/** Errors that the page has logged since the test began (each-file.ts). */
export const complaints: string[] = [];
window.addEventListener("error", (event) => complaints.push(String(event.message)));

/** Parts of the core come from files (web/vitest.page.config.ts). */
globalThis.fetch = (async (path: string) => {
  const bytes = await readFile(path);
  return { ok: true, status: 200, arrayBuffer: async () => new Uint8Array(bytes).buffer };
}) as unknown as typeof fetch;
Object.assign(WebAssembly, { instantiateStreaming: undefined });

/** The colours and the pace of a person who wants no motion, as in the tests with a browser. */
window.matchMedia = (query: string) =>
  Object.assign(new EventTarget(), {
    matches: query.includes("prefers-reduced-motion: reduce"),
    media: query,
    onchange: null,
    addListener: () => {},
    removeListener: () => {},
  }) as MediaQueryList;

let copied = "";
Object.defineProperty(navigator, "clipboard", {
  configurable: true,
  value: {
    readText: async () => copied,
    async writeText(text: string) {
      copied = text;
    },
  },
});

const OPEN = "data-popover-open";

function toggled(menu: HTMLElement, open: boolean): void {
  if (menu.hasAttribute(OPEN) === open) return;
  menu.toggleAttribute(OPEN, open);
  const states = { oldState: open ? "closed" : "open", newState: open ? "open" : "closed" };
  menu.dispatchEvent(Object.assign(new Event("toggle"), states));
}

Object.assign(HTMLElement.prototype, {
  showPopover(this: HTMLElement) {
    toggled(this, true);
  },
  hidePopover(this: HTMLElement) {
    toggled(this, false);
  },
  scrollIntoView() {},
  scrollTo() {},
  checkVisibility(this: HTMLElement) {
    return this.isConnected && !this.closest("[hidden]");
  },
});

/** What had the focus before each open dialog took it, which gives it back. */
const before = new WeakMap<HTMLDialogElement, Element | null>();
const { showModal, close } = HTMLDialogElement.prototype;
Object.assign(HTMLDialogElement.prototype, {
  showModal(this: HTMLDialogElement) {
    before.set(this, document.activeElement);
    showModal.call(this);
    this.querySelector<HTMLElement>("[autofocus], input, button, select")?.focus();
  },
  close(this: HTMLDialogElement) {
    if (!this.open) return;
    close.call(this);
    (before.get(this) as HTMLElement | null | undefined)?.focus();
  },
});

/** Who selects the text of a field takes the focus there. */
const { select } = HTMLInputElement.prototype;
HTMLInputElement.prototype.select = function (this: HTMLInputElement): void {
  if (document.activeElement !== this) this.focus();
  select.call(this);
};

/** Selectors that a DOM without layers does not know. */
const known = (selector: string): string =>
  selector.replaceAll(":popover-open", `[${OPEN}]`).replaceAll(":modal", "dialog[open]");

for (const node of [document, Element.prototype]) {
  const { querySelector, querySelectorAll } = node;
  node.querySelector = function (this: Element, selector: string) {
    return querySelector.call(this, known(selector));
  } as never;
  node.querySelectorAll = function (this: Element, selector: string) {
    return querySelectorAll.call(this, known(selector));
  } as never;
}

/** What the page offered to save last, and the file that it was asked to open. */
export interface Hold {
  saved: { readonly name: string; readonly blob: Blob }[];
  asked: HTMLInputElement[];
}

const hold: Hold = { saved: [], asked: [] };
Object.assign(globalThis, { planishHold: hold });

const blobs = new Map<string, Blob>();
URL.createObjectURL = (blob: Blob): string => {
  const name = `blob:planish/${blobs.size}`;
  blobs.set(name, blob);
  return name;
};
URL.revokeObjectURL = () => {};

const { click } = HTMLElement.prototype;
HTMLAnchorElement.prototype.click = function (this: HTMLAnchorElement): void {
  const blob = blobs.get(this.href);
  if (blob && this.download) hold.saved.push({ name: this.download, blob });
  else click.call(this);
};
HTMLInputElement.prototype.click = function (this: HTMLInputElement): void {
  if (this.type === "file") hold.asked.push(this);
  else click.call(this);
};

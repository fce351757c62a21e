// SPDX-License-Identifier: MIT
// <planish-editor>: the Planish page in a frame, for other people's pages. One file that imports
// types alone. What the two sides say to each other is here, too; the page takes the types from here.

import type { MeshFormat } from "./mesh-format.ts";

/** Of the messages. Another one is refused on both sides. */
export const EMBED_VERSION = 1;

/** A design as its JSON file holds it; docs/formats.md says what is in it. */
export type DesignJson = Readonly<Record<string, unknown>>;

export type ExportKind = MeshFormat | "json" | "png";
export type EditorUnit = "mm" | "cm" | "m" | "km" | "in" | "ft";
export type EditorTheme = "light" | "dark" | "auto";

/** What became of a design that was set. */
export interface SetOutcome {
  /** Whether it was computed again with the result that it holds, but for rounding. */
  readonly verified: boolean;
  /** `verified` in words. */
  readonly sentence: string;
}

/** The finished design that is shown. */
export interface DesignDetail {
  /** Of the solve: "converged", ... */
  readonly status: string;
  readonly points: number;
  readonly movedPoints: number;
  /** Model units. */
  readonly largestMove: number;
  /** How far the farthest handle is from its target, model units. */
  readonly handleError: number;
  /** Of the points that moved and where to; the same hash is the same result. */
  readonly hash: number;
}

export interface StatusDetail {
  /** What runs, in words; null: nothing. */
  readonly doing: string | null;
  /** What went wrong, in words. */
  readonly problem: string | null;
  /** What else the page says. */
  readonly notice: string | null;
}

export interface SelectDetail {
  /** Points, the latest last. */
  readonly vertices: readonly number[];
  readonly panel: number | null;
}

export interface ReadyDetail {
  readonly version: number;
}

/** What the page tells without being asked. */
export interface EditorDetails {
  readonly ready: ReadyDetail;
  readonly design: DesignDetail;
  readonly status: StatusDetail;
  readonly select: SelectDetail;
}

/** What the page is asked for, with what it answers. */
export interface EditorRequests {
  design: { readonly given: null; readonly answer: DesignJson };
  set: { readonly given: DesignJson; readonly answer: SetOutcome };
  export: { readonly given: ExportKind; readonly answer: Blob };
  look: { readonly given: EditorLook; readonly answer: null };
}

export interface EditorLook {
  readonly readonly: boolean;
  /** null: as the page has it. */
  readonly unit: EditorUnit | null;
}

type Key = keyof EditorRequests;

/** From the element to the page; the page answers with the same `ask`. */
export type EditorRequest = {
  [K in Key]: {
    readonly planish: number;
    readonly ask: number;
    readonly kind: K;
    readonly given: EditorRequests[K]["given"];
  };
}[Key];

/** From the page to the element. */
export type EditorMessage =
  | {
      [K in keyof EditorDetails]: {
        readonly planish: number;
        readonly event: K;
        readonly detail: EditorDetails[K];
      };
    }[keyof EditorDetails]
  | { readonly planish: number; readonly ask: number; readonly answer: unknown }
  | { readonly planish: number; readonly ask: number; readonly error: string };

interface Waiting {
  readonly resolve: (answer: unknown) => void;
  readonly reject: (reason: Error) => void;
}

const ATTRIBUTES = ["src", "readonly", "sandbox", "unit", "theme"] as const;
const STYLE = ":host{display:block;height:600px}iframe{width:100%;height:100%;border:0}";

/** A message of Planish, of whatever version. */
function isMessage(data: unknown): data is EditorMessage {
  return typeof data === "object" && data !== null && "planish" in data;
}

/** Attributes: src, readonly, sandbox, unit, theme. Events: ready, design, status, select. */
// biome-ignore lint/suspicious/noUnsafeDeclarationMerging: the interface only types events
export class PlanishEditor extends HTMLElement {
  static readonly observedAttributes = ATTRIBUTES;
  readonly #frame = document.createElement("iframe");
  readonly #waiting = new Map<number, Waiting>();
  #asked = 0;
  #isReady = false;

  constructor() {
    super();
    const style = document.createElement("style");
    style.textContent = STYLE;
    this.#frame.title = "Planish";
    this.attachShadow({ mode: "open" }).append(style, this.#frame);
  }

  /** Address of a Planish site, with a design's link after # if there is one; default where this file is. */
  get src(): string {
    return new URL(this.getAttribute("src") ?? ".", this.#base).href;
  }
  set src(address: string) {
    this.setAttribute("src", address);
  }

  /** Whether the design can only be looked at. */
  get readonly(): boolean {
    return this.hasAttribute("readonly");
  }
  set readonly(on: boolean) {
    this.toggleAttribute("readonly", on);
  }

  /** Whether the page runs in an origin of its own, without storage and without this page's rights. */
  get sandbox(): boolean {
    return this.hasAttribute("sandbox");
  }
  set sandbox(on: boolean) {
    this.toggleAttribute("sandbox", on);
  }

  /** The unit of the model's numbers. */
  get unit(): EditorUnit | null {
    return this.getAttribute("unit") as EditorUnit | null;
  }
  set unit(unit: EditorUnit | null) {
    if (unit === null) this.removeAttribute("unit");
    else this.setAttribute("unit", unit);
  }

  get theme(): EditorTheme {
    const given = this.getAttribute("theme");
    return given === "light" || given === "dark" ? given : "auto";
  }
  set theme(theme: EditorTheme) {
    this.setAttribute("theme", theme);
  }

  /** The design that is shown, to be kept or set again; rejects with a sentence. */
  design(): Promise<DesignJson> {
    return this.#ask("design", null);
  }

  /** Opens a design, which is computed again and held against the result that it holds. */
  set(design: DesignJson): Promise<SetOutcome> {
    return this.#ask("set", design);
  }

  /** The design that is shown as a file. */
  export(kind: ExportKind): Promise<Blob> {
    return this.#ask("export", kind);
  }

  connectedCallback(): void {
    window.addEventListener("message", this.#receive);
    this.#load();
  }

  disconnectedCallback(): void {
    window.removeEventListener("message", this.#receive);
    this.#giveUp("The editor was removed.");
  }

  attributeChangedCallback(
    name: (typeof ATTRIBUTES)[number],
    before: string | null,
    now: string | null,
  ): void {
    if (before === now || !this.isConnected) return;
    if (name === "theme") this.#showTheme();
    else if (name === "src" || name === "sandbox") this.#load();
    else this.#ask("look", this.#look).catch(() => {}); // whoever asks the page for more learns why
  }

  get #base(): string {
    return this.hasAttribute("src") ? document.baseURI : import.meta.url;
  }

  get #look(): EditorLook {
    return { readonly: this.readonly, unit: this.unit };
  }

  #showTheme(): void {
    this.#frame.style.colorScheme = this.theme === "auto" ? "light dark" : this.theme;
  }

  /** The page learns who may talk to it from its own address. */
  #load(): void {
    this.#giveUp("The editor shows another page.");
    const address = new URL(this.src);
    address.searchParams.set("embed", location.origin);
    if (this.readonly) address.searchParams.set("readonly", "");
    if (this.unit) address.searchParams.set("unit", this.unit);
    this.#showTheme();
    if (this.sandbox) this.#frame.setAttribute("sandbox", "allow-scripts");
    else this.#frame.removeAttribute("sandbox");
    this.#frame.src = address.href;
  }

  #giveUp(sentence: string): void {
    this.#isReady = false;
    for (const { reject } of this.#waiting.values()) reject(new Error(sentence));
    this.#waiting.clear();
  }

  async #ask<K extends Key>(
    kind: K,
    given: EditorRequests[K]["given"],
  ): Promise<EditorRequests[K]["answer"]> {
    if (!this.#isReady) await this.#becomesReady();
    const ask = ++this.#asked;
    return new Promise((resolve, reject) => {
      this.#waiting.set(ask, { resolve: resolve as Waiting["resolve"], reject });
      // An origin of its own has no name that a message could be addressed to.
      const to = this.sandbox ? "*" : new URL(this.src).origin;
      this.#frame.contentWindow?.postMessage({ planish: EMBED_VERSION, ask, kind, given }, to);
    });
  }

  #becomesReady(): Promise<void> {
    return new Promise((resolve) => {
      this.addEventListener("ready", () => resolve(), { once: true });
    });
  }

  readonly #receive = ({ source, origin, data }: MessageEvent<unknown>): void => {
    const expected = this.sandbox ? "null" : new URL(this.src).origin;
    if (source === null || source !== this.#frame.contentWindow || origin !== expected) return;
    if (!isMessage(data)) return;
    if (data.planish !== EMBED_VERSION) {
      const problem = `The page speaks version ${data.planish}, this element ${EMBED_VERSION}.`;
      this.#giveUp(problem);
      this.#tell("status", { doing: null, problem, notice: null });
    } else if ("event" in data) this.#tell(data.event, data.detail);
    else this.#settle(data);
  };

  #settle(message: Extract<EditorMessage, { readonly ask: number }>): void {
    const waiting = this.#waiting.get(message.ask);
    this.#waiting.delete(message.ask);
    if ("error" in message) waiting?.reject(new Error(message.error));
    else waiting?.resolve(message.answer);
  }

  #tell<K extends keyof EditorDetails>(event: K, detail: EditorDetails[K]): void {
    if (event === "ready") this.#isReady = true;
    this.dispatchEvent(new CustomEvent(event, { detail }));
  }
}

/** What addEventListener knows of the element. */
export interface PlanishEditorEvents {
  ready: CustomEvent<ReadyDetail>;
  design: CustomEvent<DesignDetail>;
  status: CustomEvent<StatusDetail>;
  select: CustomEvent<SelectDetail>;
}

export interface PlanishEditor {
  addEventListener<K extends keyof PlanishEditorEvents>(
    type: K,
    listener: (this: PlanishEditor, event: PlanishEditorEvents[K]) => unknown,
    options?: boolean | AddEventListenerOptions,
  ): void;
  addEventListener(
    type: string,
    listener: EventListenerOrEventListenerObject,
    options?: boolean | AddEventListenerOptions,
  ): void;
}

declare global {
  interface HTMLElementTagNameMap {
    "planish-editor": PlanishEditor;
  }
}

if (!customElements.get("planish-editor")) customElements.define("planish-editor", PlanishEditor);

// SPDX-License-Identifier: MIT
// The page that this one is embedded in. It is the window above, and its origin is the one that this
// page was loaded for; whatever else sends a message is not heard.
import type {
  EditorMessage,
  EditorRequest,
  PlanishEditor,
} from "../../../wasm/package/src/planish-editor.ts";

/** The element's EMBED_VERSION, whose file is none of the page's. */
const VERSION = 1;

export type { EditorMessage, EditorRequest, PlanishEditor };

/** What `answer` gives or rejects with goes back to whoever asked. */
export type Answering = (request: EditorRequest) => Promise<unknown>;

export class Host {
  readonly #origin: string;

  /** @param origin "null" for a page without one */
  constructor(origin: string) {
    this.#origin = origin;
  }

  tell(
    message: EditorMessage extends infer M ? (M extends M ? Omit<M, "planish"> : never) : never,
  ) {
    const to = this.#origin === "null" ? "*" : this.#origin;
    window.parent.postMessage({ planish: VERSION, ...message }, to);
  }

  listen(answering: Answering): void {
    window.addEventListener("message", ({ source, origin, data }: MessageEvent<unknown>) => {
      if (source !== window.parent || origin !== this.#origin || !isRequest(data)) return;
      void this.#answer(data, answering);
    });
  }

  async #answer(request: EditorRequest, answering: Answering): Promise<void> {
    const { ask, planish } = request;
    try {
      if (planish !== VERSION)
        throw new Error(`This page speaks version ${VERSION} of messages, not ${planish}.`);
      this.tell({ ask, answer: await answering(request) });
    } catch (error) {
      this.tell({ ask, error: error instanceof Error ? error.message : String(error) });
    }
  }
}

/** Whether it is a request, of whatever version. */
const isRequest = (data: unknown): data is EditorRequest =>
  typeof data === "object" && data !== null && "planish" in data && "ask" in data;

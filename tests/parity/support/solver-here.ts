// SPDX-License-Identifier: MIT
import type { PlanishModule } from "@wasm/planish.mjs";
import { Dispatcher } from "../../../web/src/solver/dispatch.ts";
import type { OpenedMesh, Reply, Request } from "../../../web/src/solver/protocol.ts";

type Question = Exclude<Request, { kind: "start" }>;

/** The page's own dispatcher without a worker: what it is asked, and all that it says to the last question. */
export class SolverHere {
  readonly replies: Reply[] = [];
  readonly #dispatcher: Dispatcher;

  constructor(module: PlanishModule) {
    this.#dispatcher = new Dispatcher(module, (reply) => this.replies.push(reply));
  }

  /** The reply of that kind; without one it throws what was said instead. */
  async ask<K extends Reply["kind"]>(
    question: Question,
    kind: K,
  ): Promise<Extract<Reply, { kind: K }>> {
    this.replies.length = 0;
    await this.#dispatcher.handle(question);
    const reply = this.replies.find((one) => one.kind === kind);
    if (!reply) throw new Error(JSON.stringify(this.replies));
    return reply as Extract<Reply, { kind: K }>;
  }

  async openSample(name: string, size: number): Promise<OpenedMesh> {
    const source = { kind: "sample", name, size } as const;
    const bare = { planarise: null, symmetry: null, cuts: [] };
    return (await this.ask({ kind: "open", job: 1, source, ...bare }, "opened")).mesh;
  }
}

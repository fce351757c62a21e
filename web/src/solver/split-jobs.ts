// SPDX-License-Identifier: MIT
// What the worker answers to whoever tries cuts and splits: the mesh that is open stays as it is.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import type { DesignAnalysis } from "./analysis.ts";
import type { Edits } from "./edits.ts";
import { openedBuffers, readMesh } from "./opened-mesh.ts";
import type { Reply, Request } from "./protocol.ts";
import { insist } from "./refused.ts";

export type Post = (reply: Reply, transfer: Transferable[]) => void;

export type SplitJob = Extract<Request, { kind: "tryCut" | "splitEdit" | "splitMesh" }>;

export class SplitJobs {
  readonly #module: PlanishModule;
  readonly #session: Session;
  readonly #edits: Edits;
  readonly #analysis: DesignAnalysis;
  readonly #post: Post;

  constructor(
    module: PlanishModule,
    session: Session,
    parts: { readonly edits: Edits; readonly analysis: DesignAnalysis; readonly post: Post },
  ) {
    this.#module = module;
    this.#session = session;
    this.#edits = parts.edits;
    this.#analysis = parts.analysis;
    this.#post = parts.post;
  }

  run(request: SplitJob): void {
    if (request.kind === "tryCut") this.#tryCut(request);
    else if (request.kind === "splitEdit") this.#splitEdit(request);
    else this.#splitMesh(request);
  }

  #tryCut({ job, cut, tolerance }: Extract<SplitJob, { kind: "tryCut" }>): void {
    const trial = this.#session.tryCut(cut, tolerance);
    this.#post({ kind: "tried", job, trial }, [trial.lines.buffer]);
  }

  #splitEdit(request: Extract<SplitJob, { kind: "splitEdit" }>): void {
    const { job } = request;
    const finding = this.#edits.split(request, (standing) =>
      this.#post({ kind: "standing", job, standing }, []),
    );
    this.#post({ kind: "split", job, finding }, []);
  }

  #splitMesh({ job, how, most }: Extract<SplitJob, { kind: "splitMesh" }>): void {
    const session = this.#session;
    insist(this.#module.splitUntilFlat(session, how, most));
    this.#analysis.forget();
    const mesh = readMesh(this.#module, session, []);
    const [panels, file] = [this.#module.splitPanels(session), session.write("obj")];
    const buffers = [file.buffer as Transferable, ...openedBuffers(mesh)];
    this.#post({ kind: "hybrid", job, mesh, panels, file }, buffers);
  }
}

// SPDX-License-Identifier: MIT
// What the worker does with each request; testable without a worker.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { buffersOf, prepareDisplay } from "../mesh/display-mesh.ts";
import { DesignAnalysis, type ShapeFamily } from "./analysis.ts";
import { SUPPORT_WORDS } from "./boundary-support.ts";
import { fairLimit } from "./fair-folds.ts";
import { openGlb, readDesign, writeDesign, writeGlb } from "./glb.ts";
import type {
  AlsoMeasured,
  EditMode,
  EditSettings,
  FileFormat,
  OpenedMesh,
  Reply,
  Request,
  Shape,
  SliderLead,
  Source,
  StoredDesign,
  Targets,
} from "./protocol.ts";
import { type HandleList, isWithin, PullHold } from "./pull-limit.ts";
import { aboutFile, keepCopy, readFile, readGiven, readKept } from "./reading.ts";
import { offsetOf, previewPackage, writeForShop } from "./shop.ts";
import { leadsOf, rangesOf } from "./sliders.ts";

export type Post = (reply: Reply, transfer: Transferable[]) => void;

type Job = Exclude<Request, { kind: "start" }>;

/** Jobs that wait for something: a file, a module. */
type Waited =
  | "open"
  | "read"
  | "readDesign"
  | "export"
  | "shop"
  | "preview"
  | "unpack"
  | "model"
  | "offset";

/** Raised by an operation that the session refused; its message is for the user. */
class Refused extends Error {}

const NO_MEMORY = "There is not enough memory for this mesh in the browser.";

function insist(refusal: string): void {
  if (refusal) throw new Refused(refusal);
}

function insistReadable(name: string, refusal: string): void {
  insist(refusal && refusal !== NO_MEMORY ? aboutFile(name, refusal) : refusal);
}

/** After these the module's memory is full or in no known state. */
const isFatal = (error: unknown): boolean =>
  error instanceof WebAssembly.RuntimeError ||
  error instanceof RangeError ||
  (error instanceof Refused && error.message === NO_MEMORY);

function sentence(error: unknown): string {
  // "OOM" is how the module's allocator ends.
  if (error instanceof WebAssembly.RuntimeError && !error.message.includes("OOM"))
    return "The solver stopped unexpectedly. Your last finished design is back.";
  if (isFatal(error)) return `${NO_MEMORY} Your last finished design is back.`;
  return error instanceof Error ? error.message : String(error);
}

function readMesh(session: Session, warnings: readonly string[]): OpenedMesh {
  const report = session.meshReport();
  return {
    report: { ...report, warnings: [...warnings, ...report.warnings] },
    positions: session.basePositions(),
    ...prepareDisplay({
      display: session.displayBase(),
      offsets: session.faceOffsets(),
      vertices: session.faceVertices(),
    }),
  };
}

/** That a drag may wait for its limit. */
const SEARCH_MS = 2000;

const WRITERS = { glb: writeGlb, json: writeDesign } as const;

const asIs = (mesh: Uint8Array, { format }: { format: FileFormat }) => ({ mesh, format });

const rhinoPart = () =>
  import("./rhino.ts").catch(() => {
    throw new Refused("The part for Rhino could not be loaded. Try again online.");
  });

/** Answers requests in order on one session. A request that fails leaves the session as it was. */
export class Dispatcher {
  readonly #module: PlanishModule;
  readonly #session: Session;
  readonly #post: Post;
  readonly #analysis: DesignAnalysis;
  #hold = new PullHold();
  /** Found last. */
  #family: ShapeFamily | null = null;
  #settings: EditSettings | null = null;
  #job = 0;
  #step = 0;

  constructor(module: PlanishModule, post: Post) {
    this.#module = module;
    this.#session = new module.Session();
    this.#analysis = new DesignAnalysis(this.#session, () =>
      post({ kind: "measurable", job: 0 }, []),
    );
    this.#post = post;
    this.#session.onProgress((residual) => {
      this.#post({ kind: "progress", job: this.#job, step: ++this.#step, residual }, []);
      return true;
    });
  }

  async handle(request: Job): Promise<void> {
    const { job } = request;
    this.#job = job;
    this.#step = 0;
    try {
      if (request.kind === "open") await this.#open(request);
      else if (request.kind === "read") await this.#read(request);
      else if (request.kind === "export") await this.#export(request);
      else if (request.kind === "readDesign") await this.#readDesign(request);
      else if (request.kind === "shop") await this.#shop(request);
      else if (request.kind === "preview") await this.#preview(request);
      else if (request.kind === "offset") await this.#offset(request);
      else if (request.kind === "unpack") await this.#unpack(request);
      else if (request.kind === "model") await this.#model(request);
      else this.#run(request);
    } catch (error) {
      this.#post({ kind: "failed", job, message: sentence(error), fatal: isFatal(error) }, []);
    }
  }

  readonly #onPiece = (done: number, total: number): void =>
    this.#post({ kind: "reading", job: this.#job, done, total }, []);

  async #open({ job, source, planarise }: Extract<Request, { kind: "open" }>): Promise<void> {
    const session = this.#session;
    if (source.kind === "sample") insist(session.openSample(source.name, source.size));
    else {
      const bytes = await readKept(source, this.#onPiece);
      const { name } = source;
      const { mesh, format } =
        source.format === "glb" ? await openGlb(name, bytes) : asIs(bytes, source);
      insistReadable(name, session.openFile(mesh, format));
    }
    if (planarise) insist(session.planarise(planarise));
    this.#postOpened(job, null, null);
  }

  async #read({ job, file, name, format }: Extract<Request, { kind: "read" }>): Promise<void> {
    const read = await readFile(file, name, format, this.#onPiece);
    if (format !== "glb") {
      insistReadable(name, this.#session.openFile(read.bytes, format));
      this.#postOpened(job, read.source, null);
      return;
    }
    const { mesh, stored } = await openGlb(name, read.bytes);
    insist(this.#session.openFile(mesh, "obj"));
    this.#postOpened(job, keepCopy(name, "obj", mesh), stored);
  }

  async #export(request: Extract<Request, { kind: "export" }>): Promise<void> {
    const { job, format } = request;
    const bytes =
      request.design === null
        ? this.#session.write(request.format)
        : await WRITERS[request.format](this.#session, request.design, request.offset);
    if (bytes.length === 0) throw new Refused(`${format.toUpperCase()} cannot be written.`);
    this.#post({ kind: "exported", job, bytes }, [bytes.buffer]);
  }

  async #readDesign({ job, text }: Extract<Request, { kind: "readDesign" }>): Promise<void> {
    this.#post({ kind: "design", job, reading: await readDesign(text) }, []);
  }

  async #shop({ job, order }: Extract<Request, { kind: "shop" }>): Promise<void> {
    this.#post({ kind: "made", job, ...(await writeForShop(this.#session, order)) }, []);
  }

  async #preview(request: Extract<Request, { kind: "preview" }>): Promise<void> {
    const { job, options, face, map } = request;
    const preview = await previewPackage(this.#session, options, face, map);
    this.#post({ kind: "previewed", job, preview }, []);
  }

  async #offset({ job, distance, form }: Extract<Request, { kind: "offset" }>): Promise<void> {
    const offset = await offsetOf(this.#session, distance, form);
    this.#post({ kind: "offset", job, offset }, []);
  }

  async #unpack({ job, file, name }: Extract<Request, { kind: "unpack" }>): Promise<void> {
    const bytes = await readGiven(file, name, this.#onPiece);
    const { openRhino } = await rhinoPart();
    const model = await openRhino(name, bytes);
    const { lines, triangles, points } = model.context ?? {};
    const drawn = [lines, triangles, points].flatMap((list) => (list ? [list.buffer] : []));
    this.#post({ kind: "unpacked", job, model }, [model.mesh.buffer, ...drawn]);
  }

  async #model({ job, unit, design }: Extract<Request, { kind: "model" }>): Promise<void> {
    const { writeRhino } = await rhinoPart();
    const model = await writeRhino(this.#session, unit, design);
    this.#post({ kind: "modelled", job, model }, [model.bytes.buffer]);
  }

  #run(request: Exclude<Job, { kind: Waited }>): void {
    const session = this.#session;
    const { job } = request;
    switch (request.kind) {
      case "planarise":
        insist(
          request.found ? session.takePlanarised(request.found) : session.planarise(request.how),
        );
        this.#postOpened(job, null, null);
        return;
      case "edit":
        this.#edit(request);
        return;
      case "restore":
        insist(this.#restore(request));
        this.#postShown(job, true);
        return;
      case "replay":
        this.#replay(request);
        return;
      case "mark": {
        const { moved, positions } = request.shape;
        this.#post({ kind: "marked", job, mark: this.#module.markOf(moved, positions) }, []);
        return;
      }
      case "explore":
        this.#explore(request);
        return;
      case "stops":
        this.#postStops(job, request.coefficients);
        return;
      case "vary":
        insist(session.vary(Float64Array.from(request.coefficients)));
        this.#postShown(job, false);
        return;
      case "exact":
        insist(session.makeExact());
        this.#postShown(job, true);
        return;
      case "project":
        insist(session.projectVariation(Float64Array.from(request.coefficients)));
        this.#postProjected(job);
        return;
      case "panels":
        this.#postMeasures(job, request.also);
        return;
      case "measure":
        this.#post({ kind: "panels", job, measures: this.#analysis.measure(request.shape) }, []);
        return;
      case "freedom":
        this.#post({ kind: "freedom", job, freedom: this.#analysis.freedom(request.targets) }, []);
        return;
    }
  }

  #postMeasures(job: number, also: AlsoMeasured): void {
    const measures = this.#analysis.panels(also);
    const parts: readonly unknown[] = Object.values(measures ?? {});
    const buffers = parts.flatMap((part) => (ArrayBuffer.isView(part) ? [part.buffer] : []));
    this.#post({ kind: "panels", job, measures }, buffers);
  }

  #edit(request: Extract<Request, { kind: "edit" }>): void {
    const { job, mode, targets, settings, budget, limit } = request;
    this.#setOptions(settings);
    const session = this.#session;
    const pins = Int32Array.from(targets.pins);
    const steps = mode === "solve" ? settings.continuation : 0;
    const attempt = (handles: HandleList, how: EditMode): void => {
      const to = Float64Array.from(handles);
      insist(session.edit(this.#module.EditMode[how], to, pins, steps, budget));
    };
    if (!limit) {
      this.#hold = new PullHold();
      attempt(targets.handles, mode);
      const stated = this.#unfold(request, () => attempt(targets.handles, mode));
      this.#postShown(job, mode !== "drag", null, stated);
      return;
    }
    if (mode !== "drag") this.#hold = new PullHold();
    const once = (handles: HandleList, settled: boolean): boolean => {
      if (settled && mode === "drag") session.goBack();
      attempt(handles, settled && mode !== "drag" ? "solve" : mode);
      return isWithin(limit, session.shapeReport());
    };
    const patience = mode === "drag" ? SEARCH_MS : Number.POSITIVE_INFINITY;
    const taken = this.#hold.take(limit.from, targets.handles, once, patience);
    if (mode === "drag") session.keepFrame();
    this.#postShown(job, mode !== "drag", taken === targets.handles ? null : taken);
  }

  /** Makes the edit again with the limit on folds that costs its handles nothing, if there is one. */
  #unfold(request: Extract<Request, { kind: "edit" }>, again: () => void): string | null {
    const { settings, fairWay } = request;
    if (fairWay === null) return null;
    let tried = false;
    const stated = fairLimit(this.#session.shapeReport(), fairWay, (limit) => {
      tried = true;
      this.#setOptions({ ...settings, limits: [...settings.limits, limit] });
      again();
      return this.#session.shapeReport();
    });
    if (tried && stated === null) {
      this.#setOptions(settings);
      again();
    }
    return stated;
  }

  /** Options that stay the same keep the solver's warm start; each message is a copy. */
  #setOptions(given: EditSettings): void {
    const settings = { ...given, continuation: 0 }; // each edit has its own
    if (JSON.stringify(settings) === JSON.stringify(this.#settings)) return;
    this.#settings = null; // where one of them is refused, the others hold already
    insist(this.#session.setOptions(settings));
    insist(this.#session.setSupports(SUPPORT_WORDS[settings.boundarySupport]));
    this.#settings = settings;
  }

  #replay({ job, design }: Extract<Request, { kind: "replay" }>): void {
    const session = this.#session;
    this.#hold = new PullHold();
    this.#settings = null; // the design brings its own
    const { source } = design;
    insist(session.replay(design, "hash" in source ? source.hash : null));
    const { directions, deviation, moved, positions } = session.replayed();
    const centre = { moved, positions };
    const changes = session.takeChanges();
    const reply: Reply = {
      kind: "replayed",
      job,
      changes,
      report: session.shapeReport(),
      shape: { moved: session.moved(), positions: session.movedPositions() },
      directions: [...directions],
      centre,
      leads: this.#takeFamily(centre),
      deviation,
    };
    this.#post(reply, [changes.buffer]);
  }

  #restore({ targets, settings, shape, keep }: Extract<Request, { kind: "restore" }>): string {
    this.#hold = new PullHold();
    this.#setOptions(settings);
    return this.#show(targets, shape, keep);
  }

  #show(targets: Targets, { moved, positions }: Shape, keep: boolean): string {
    const handles = Float64Array.from(targets.handles);
    const pins = Int32Array.from(targets.pins);
    return this.#session.restore(handles, pins, moved, positions, keep);
  }

  #postProjected(job: number): void {
    const session = this.#session;
    const [moved, positions] = [session.projectedMoved(), session.projectedPositions()];
    const report = session.projectedReport();
    const reply: Reply = { kind: "projected", job, shape: { moved, positions }, report };
    this.#post(reply, [moved.buffer, positions.buffer]);
  }

  #explore({ job, family }: Extract<Request, { kind: "explore" }>): void {
    const session = this.#session;
    insist(session.explore(family));
    const centre = { moved: session.moved(), positions: session.movedPositions() };
    const leads = this.#takeFamily(centre);
    this.#post({ kind: "explored", job, report: session.variationsReport(), leads }, []);
  }

  /** What the sliders around `centre` do; none if nothing was found. */
  #takeFamily(centre: Shape): SliderLead[] {
    const session = this.#session;
    const [support, moves] = [session.variationSupport(), session.variationDisplacements()];
    this.#family = { centre, support, moves };
    return leadsOf(this.#family);
  }

  #postStops(job: number, coefficients: readonly number[]): void {
    const stops = this.#family && this.#analysis.stops(this.#family, coefficients);
    this.#post({ kind: "stops", job, ranges: stops && rangesOf(stops) }, []);
  }

  #postOpened(job: number, source: Source | null, stored: StoredDesign | null): void {
    this.#analysis.forget();
    const mesh = readMesh(this.#session, stored?.warnings ?? []);
    const buffers = [mesh.positions.buffer, ...buffersOf(mesh)];
    this.#post({ kind: "opened", job, source, mesh, stored }, buffers as Transferable[]);
  }

  #postShown(
    job: number,
    withShape: boolean,
    taken: HandleList | null = null,
    stated: string | null = null,
  ): void {
    const session = this.#session;
    const changes = session.takeChanges();
    const report = session.shapeReport();
    const shape = withShape
      ? { moved: session.moved(), positions: session.movedPositions() }
      : null;
    const buffers: Transferable[] = [changes.buffer];
    if (shape) buffers.push(shape.moved.buffer, shape.positions.buffer);
    this.#post({ kind: "shown", job, changes, report, shape, taken, stated }, buffers);
  }
}

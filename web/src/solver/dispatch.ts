// SPDX-License-Identifier: MIT
// What the worker does with each request; testable without a worker.

import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { turnedObj } from "../mesh/up-axis.ts";
import { makeAlike } from "./alike.ts";
import { DesignAnalysis, type ShapeFamily } from "./analysis.ts";
import { DesignFiles } from "./design-files.ts";
import { type Edited, Edits } from "./edits.ts";
import type { FileFormat } from "./file-formats.ts";
import { openedBuffers, readMesh } from "./opened-mesh.ts";
import type {
  PanelMeasures,
  Reply,
  Request,
  Shape,
  SliderLead,
  Source,
  StoredDesign,
  Symmetry,
} from "./protocol.ts";
import { keepCopy, readFile, readGiven, readKept } from "./reading.ts";
import { insist, insistReadable, isFatal, Refused, sentence } from "./refused.ts";
import { rhinoPart } from "./rhino-part.ts";
import { offsetOf, panelTypes, previewPackage, writeForShop } from "./shop.ts";
import { leadsOf, rangesOf } from "./sliders.ts";
import { type Post, SplitJobs } from "./split-jobs.ts";

type Job = Exclude<Request, { kind: "start" }>;

/** Jobs that wait for something: a file, a module. */
type Waited =
  | "open"
  | "read"
  | "join"
  | "turn"
  | "alike"
  | "readDesign"
  | "export"
  | "shop"
  | "preview"
  | "types"
  | "readModel"
  | "unpack"
  | "model"
  | "offset";

const AS_ASKED: Edited = { taken: null, found: [], reach: null, placed: null };

const asIs = (mesh: Uint8Array, { format }: { format: FileFormat }) => ({ mesh, format });

/** Milliseconds between two steps that are told: many solves in a row take thousands. */
const SAYING_MS = 25;

/** Answers requests in order on one session. A request that fails leaves the session as it was. */
export class Dispatcher {
  readonly #module: PlanishModule;
  readonly #session: Session;
  readonly #post: Post;
  readonly #analysis: DesignAnalysis;
  readonly #edits: Edits;
  readonly #splits: SplitJobs;
  readonly #files = new DesignFiles();
  /** Found last. */
  #family: ShapeFamily | null = null;
  #job = 0;
  #step = 0;
  /** When a step was told last. */
  #saidAt = 0;

  constructor(module: PlanishModule, post: Post) {
    this.#module = module;
    this.#session = new module.Session();
    this.#analysis = new DesignAnalysis(module, this.#session);
    this.#edits = new Edits(module, this.#session, () => this.#analysis.slivers());
    this.#post = post;
    const parts = { edits: this.#edits, analysis: this.#analysis, post };
    this.#splits = new SplitJobs(module, this.#session, parts);
    this.#session.onProgress((residual) => {
      this.#say(this.#step + 1, residual);
      return true;
    });
  }

  #say(step: number, residual: number): void {
    this.#step = step;
    const now = performance.now();
    if (step > 1 && now < this.#saidAt + SAYING_MS) return;
    this.#saidAt = now;
    this.#post({ kind: "progress", job: this.#job, step, residual }, []);
  }

  async handle(request: Job): Promise<void> {
    const { job } = request;
    this.#job = job;
    this.#step = 0;
    try {
      if (request.kind === "open") await this.#open(request);
      else if (request.kind === "read") await this.#read(request);
      else if (request.kind === "join") await this.#join(request);
      else if (request.kind === "turn") this.#turn(request);
      else if (request.kind === "alike") await this.#alike(request);
      else if (request.kind === "export") await this.#export(request);
      else if (request.kind === "readDesign") await this.#readDesign(request);
      else if (request.kind === "shop") await this.#shop(request);
      else if (request.kind === "preview") await this.#preview(request);
      else if (request.kind === "types") await this.#types(request);
      else if (request.kind === "offset") await this.#offset(request);
      else if (request.kind === "readModel") await this.#readModel(request);
      else if (request.kind === "unpack") await this.#unpack(request);
      else if (request.kind === "model") await this.#model(request);
      else this.#run(request);
    } catch (error) {
      this.#post({ kind: "failed", job, message: sentence(error), fatal: isFatal(error) }, []);
    }
  }

  readonly #onPiece = (done: number, total: number): void =>
    this.#post({ kind: "reading", job: this.#job, done, total }, []);

  async #open(request: Extract<Request, { kind: "open" }>): Promise<void> {
    const { job, source, planarise, found, symmetry, cuts } = request;
    const session = this.#session;
    if (source.kind === "sample") insist(session.openSample(source.name, source.size));
    else {
      const bytes = await readKept(source, this.#onPiece);
      const { name } = source;
      const { mesh, format } =
        source.format === "glb" ? await this.#files.openGlb(name, bytes) : asIs(bytes, source);
      insistReadable(name, session.openFile(mesh, format));
    }
    if (planarise && found) {
      const { length } = session.basePositions();
      insist(session.takePlanarised(found.subarray(0, length)));
    } else if (planarise) insist(session.planarise(planarise));
    if (symmetry) this.#setSymmetry(symmetry);
    if (cuts.length > 0) insist(session.setCuts(cuts.join("\n"), symmetry?.tolerance ?? 0));
    this.#postOpened(job, null, null);
  }

  #setSymmetry({ elements, tolerance }: Symmetry): void {
    insist(this.#module.setSymmetry(this.#session, elements.join(","), tolerance));
  }

  async #read({ job, file, name, format }: Extract<Request, { kind: "read" }>): Promise<void> {
    const read = await readFile(file, name, format, this.#onPiece);
    if (format !== "glb") {
      insistReadable(name, this.#session.openFile(read.bytes, format));
      this.#postOpened(job, read.source, null);
      return;
    }
    const { mesh, stored } = await this.#files.openGlb(name, read.bytes);
    insist(this.#session.openFile(mesh, "obj"));
    this.#postOpened(job, keepCopy(name, "obj", mesh), stored);
  }

  async #join({ job, name, way }: Extract<Request, { kind: "join" }>): Promise<void> {
    const mesh = await this.#files.mend(way, this.#session.write("obj"));
    if (mesh.length === 0) throw new Error("That gives no mesh: an edge can have two panels.");
    insist(this.#session.openFile(mesh, "obj"));
    this.#postOpened(job, keepCopy(name, "obj", mesh), null);
  }

  #turn({ job, name, from, to }: Extract<Request, { kind: "turn" }>): void {
    const text = new TextDecoder().decode(this.#session.write("obj"));
    const mesh = new TextEncoder().encode(turnedObj(text, from, to));
    insist(this.#session.openFile(mesh, "obj"));
    this.#postOpened(job, keepCopy(name, "obj", mesh), null);
  }

  async #alike({ job, asked }: Extract<Request, { kind: "alike" }>): Promise<void> {
    const obj = this.#session.write("obj");
    const made = await makeAlike(obj, asked, (steps) => this.#say(steps, 0));
    this.#post({ kind: "alike", job, made }, [made.file.buffer]);
  }

  async #export(request: Extract<Request, { kind: "export" }>): Promise<void> {
    const { job, format } = request;
    if (request.design === null && request.groups !== null)
      insist(this.#session.setGroups(request.groups));
    const bytes =
      request.design === null
        ? this.#session.write(request.format)
        : await this.#files.write(this.#session, request);
    if (bytes.length === 0) throw new Refused(`${format.toUpperCase()} cannot be written.`);
    this.#post({ kind: "exported", job, bytes }, [bytes.buffer]);
  }

  async #readDesign({ job, text }: Extract<Request, { kind: "readDesign" }>): Promise<void> {
    this.#post({ kind: "design", job, reading: await this.#files.read(text) }, []);
  }

  async #shop({ job, order }: Extract<Request, { kind: "shop" }>): Promise<void> {
    this.#post({ kind: "made", job, ...(await writeForShop(this.#session, order)) }, []);
  }

  async #preview(request: Extract<Request, { kind: "preview" }>): Promise<void> {
    const { job, options, face, map } = request;
    const preview = await previewPackage(this.#session, options, face, map);
    this.#post({ kind: "previewed", job, preview }, []);
  }

  async #types(request: Extract<Request, { kind: "types" }>): Promise<void> {
    const { job, share, mirrored, shape } = request;
    const types = await panelTypes(this.#session, shape, share, mirrored);
    this.#post({ kind: "types", job, types }, []);
  }

  async #offset({ job, distance, form }: Extract<Request, { kind: "offset" }>): Promise<void> {
    const offset = await offsetOf(this.#session, distance, form);
    this.#post({ kind: "offset", job, offset }, []);
  }

  async #readModel(request: Extract<Request, { kind: "readModel" }>): Promise<void> {
    const { job, file, name } = request;
    const bytes = await readGiven(file, name, this.#onPiece);
    const { mesh, format } =
      request.format === "glb" ? await this.#files.openGlb(name, bytes) : asIs(bytes, request);
    const session = new this.#module.Session();
    try {
      insistReadable(name, session.openFile(mesh, format));
      const [offsets, vertices] = [session.faceOffsets(), session.faceVertices()];
      const model = { points: session.basePositions(), offsets, vertices };
      this.#post({ kind: "readModel", job, model }, []);
    } finally {
      session.delete();
    }
  }

  async #unpack({ job, file, name }: Extract<Request, { kind: "unpack" }>): Promise<void> {
    const bytes = await readGiven(file, name, this.#onPiece);
    const { openRhino } = await rhinoPart();
    const model = await openRhino(name, bytes, await this.#files.joinPoints());
    const { lines, triangles, points } = model.context ?? {};
    const drawn = [lines, triangles, points].flatMap((list) => (list ? [list.buffer] : []));
    this.#post({ kind: "unpacked", job, model }, [model.mesh.buffer, ...drawn]);
  }

  async #model({ job, unit, design }: Extract<Request, { kind: "model" }>): Promise<void> {
    const { writeRhino } = await rhinoPart();
    const text = await this.#files.text(this.#session, design);
    const model = await writeRhino(this.#session, unit, text);
    this.#post({ kind: "modelled", job, model }, [model.bytes.buffer]);
  }

  #run(request: Exclude<Job, { kind: Waited }>): void {
    const session = this.#session;
    const { job } = request;
    switch (request.kind) {
      case "planarise":
        this.#planarise(request);
        return;
      case "cut":
        insist(session.setCuts(request.cuts.join("\n"), request.tolerance));
        this.#postOpened(job, null, null);
        return;
      case "tryCut":
      case "splitEdit":
      case "splitMesh":
        this.#splits.run(request);
        return;
      case "edit":
        this.#postShown(job, request.mode !== "drag", this.#edits.edit(request));
        return;
      case "fewest":
        this.#fewest(request);
        return;
      case "restore":
        this.#edits.restore(request);
        this.#postShown(job, true);
        return;
      case "replay":
        this.#replay(request);
        return;
      case "mark":
        this.#mark(request);
        return;
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
        this.#postMeasures(job, this.#analysis.panels(request.also));
        return;
      case "measure":
        this.#postMeasures(job, this.#analysis.measure(request.shape, request.fairness));
        return;
      case "freedom":
        this.#post({ kind: "freedom", job, freedom: this.#analysis.freedom(request.targets) }, []);
        return;
    }
  }

  #postMeasures(job: number, measures: PanelMeasures): void {
    const parts: readonly unknown[] = Object.values(measures);
    const buffers = parts.flatMap((part) => (ArrayBuffer.isView(part) ? [part.buffer] : []));
    this.#post({ kind: "panels", job, measures }, buffers);
  }

  #replay({ job, design }: Extract<Request, { kind: "replay" }>): void {
    const session = this.#session;
    this.#edits.forget(); // the design brings its own options
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

  #planarise({ job, how, found }: Extract<Request, { kind: "planarise" }>): void {
    insist(found ? this.#session.takePlanarised(found) : this.#session.planarise(how));
    this.#postOpened(job, null, null);
  }

  #mark({ job, shape }: Extract<Request, { kind: "mark" }>): void {
    const mark = this.#module.markOf(shape.moved, shape.positions);
    this.#post({ kind: "marked", job, mark }, []);
  }

  #fewest(request: Extract<Request, { kind: "fewest" }>): void {
    const answer = this.#edits.fewest(request);
    const { moved, positions } = answer.shape;
    const buffers = [moved.buffer, positions.buffer];
    this.#post({ kind: "fewest", job: request.job, ...answer }, buffers);
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
    const mesh = readMesh(this.#module, this.#session, stored?.warnings ?? []);
    this.#post({ kind: "opened", job, source, mesh, stored }, openedBuffers(mesh));
  }

  #postShown(job: number, withShape: boolean, edited = AS_ASKED): void {
    const session = this.#session;
    const changes = session.takeChanges();
    const report = session.shapeReport();
    const shape = withShape
      ? { moved: session.moved(), positions: session.movedPositions() }
      : null;
    const buffers: Transferable[] = [changes.buffer];
    if (shape) buffers.push(shape.moved.buffer, shape.positions.buffer);
    this.#post({ kind: "shown", job, changes, report, shape, ...edited }, buffers);
  }
}

// SPDX-License-Identifier: MIT
// The worker that measures where a mesh can move: a point at a time, so that it can be stopped.
import type { MobilityMap, MobilityRow } from "@wasm/planish.mjs";
import wasmUrl from "@wasm/planish.wasm?url";
import type { EditSettings } from "./protocol.ts";

export type { MobilityRow } from "@wasm/planish.mjs";

export type MobilityOrder =
  | {
      readonly kind: "open";
      readonly positions: Float64Array;
      readonly offsets: Int32Array;
      readonly vertices: Int32Array;
      readonly settings: EditSettings;
    }
  | { readonly kind: "go" }
  | { readonly kind: "stop" };

export type MobilityNews =
  /** Points that were measured since the last news, with the mean of their ways up and down, and the
   * best places of all so far. */
  | {
      readonly kind: "measured";
      readonly points: Int32Array;
      readonly ways: Float32Array;
      readonly best: readonly MobilityRow[];
    }
  | { readonly kind: "failed"; readonly message: string };

/** Milliseconds between two news. */
const PACE = 250;
/** Places in the list. */
const BEST = 5;

const scope = self as unknown as DedicatedWorkerGlobalScope;
const post = (news: MobilityNews): void => scope.postMessage(news);

/** Every point once, neighbours far from each other in time: the map fills in everywhere. */
function spread(count: number): (k: number) => number {
  const divides = (a: number, b: number): number => (b === 0 ? a : divides(b, a % b));
  let step = Math.max(1, Math.round(0.618 * count));
  while (divides(step, count) !== 1) step += 1;
  return (k) => (k * step) % count;
}

let map: MobilityMap | null = null;
let opening: Promise<void> = Promise.resolve();
let count = 0;
let next = 0;
let running = false;

async function open(order: Extract<MobilityOrder, { kind: "open" }>): Promise<void> {
  const { default: create } = await import("@wasm/planish.mjs");
  const module = await create({ locateFile: () => wasmUrl });
  const { positions, offsets, vertices, settings } = order;
  const opened = module.openMap(positions, offsets, vertices, settings);
  if (!opened.map) throw new Error(opened.problem);
  map = opened.map;
  count = positions.length / 3;
}

/** Lets messages in between two points. */
const breathe = (): Promise<void> => new Promise((resolve) => setTimeout(resolve));

function measureFor(milliseconds: number, measuring: MobilityMap): void {
  const order = spread(count);
  const points: number[] = [];
  const ways: number[] = [];
  const end = performance.now() + milliseconds;
  do {
    const vertex = order(next);
    next += 1;
    const [up, down] = measuring.measure(vertex);
    points.push(vertex);
    ways.push(((up?.distance ?? 0) + (down?.distance ?? 0)) / 2);
  } while (next < count && performance.now() < end);
  post({
    kind: "measured",
    points: Int32Array.from(points),
    ways: Float32Array.from(ways),
    best: measuring.best(BEST),
  });
}

async function run(): Promise<void> {
  if (running) return;
  running = true;
  await opening;
  while (running && map && next < count) {
    measureFor(PACE, map);
    await breathe();
  }
  running = false;
}

const fail = (error: unknown): void =>
  post({ kind: "failed", message: error instanceof Error ? error.message : String(error) });

scope.onmessage = ({ data }: MessageEvent<MobilityOrder>): void => {
  if (data.kind === "open") opening = open(data);
  else if (data.kind === "stop") running = false;
  else run().catch(fail);
};

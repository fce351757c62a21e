// SPDX-License-Identifier: MIT
// The steps before and after the design that autosave keeps, a file each beside its record: a step never
// changes, so that each is written once.

import { PoolWriter } from "../bytes/number-pool.ts";
import type { Design } from "./design.ts";
import type { History } from "./history.ts";
import { packBlock, unpackBlock } from "./saved-block.ts";
import { type Files, readDesign, writeDesign } from "./saved-design.ts";

/** Keys of files, oldest first: of the steps before the design, and of those that were undone. */
export interface StepKeys {
  readonly past: readonly string[];
  readonly future: readonly string[];
}

export const NO_STEPS: StepKeys = { past: [], future: [] };

const MAGIC = 0x484e4c50; // "PLNH"
const VERSION = 1;

/** Bytes of the steps kept on either side of the design: the nearest. */
const MOST_PAST = 12e6;
const MOST_FUTURE = 4e6;

const KEY = /^step-[0-9a-z-]{1,40}$/;
export const isStepKey = (value: unknown): value is string =>
  typeof value === "string" && KEY.test(value);

interface StepFile {
  readonly key: string;
  readonly file: Blob;
}

const newKey = (): string =>
  `step-${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

function write(design: Design): StepFile {
  const pool = new PoolWriter();
  const json = { design: writeDesign(design, pool) };
  return { key: newKey(), file: new Blob([packBlock(MAGIC, VERSION, json, pool)]) };
}

async function read(file: Blob, files: Files): Promise<Design | null> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  const design = unpackBlock(MAGIC, VERSION, bytes, (json, pool) =>
    readDesign(json.design, pool, files),
  );
  return typeof design === "string" ? null : design;
}

/** Of the steps of one page. */
export class StepFiles {
  readonly #written = new WeakMap<Design, StepFile>();

  #of(design: Design): StepFile {
    const known = this.#written.get(design) ?? write(design);
    this.#written.set(design, known);
    return known;
  }

  /** The files of `steps`, nearest first, as far as they fit into `most` bytes. */
  #within(most: number, steps: Iterable<Design>): { step: Design; written: StepFile }[] {
    const all: { step: Design; written: StepFile }[] = [];
    let left = most;
    for (const step of steps) {
      const written = this.#of(step);
      left -= written.file.size;
      if (left < 0) break;
      all.push({ step, written });
    }
    return all;
  }

  /** What is kept of a history: the steps, their keys and their files. */
  keep({ past, future }: History<Design>) {
    const before = this.#within(MOST_PAST, past.toReversed()).reverse();
    const after = this.#within(MOST_FUTURE, future);
    const all = [...before, ...after];
    const keysOf = (steps: typeof all): string[] => steps.map(({ written }) => written.key);
    return {
      designs: all.map(({ step }) => step),
      keys: { past: keysOf(before), future: keysOf(after) } satisfies StepKeys,
      files: new Map(all.map(({ written: { key, file } }) => [key, file])),
    };
  }

  /** The designs of `keys`, nearest first, up to one that cannot be read. */
  async #read(keys: readonly string[], files: Files): Promise<Design[]> {
    const designs: Design[] = [];
    for (const key of keys) {
      const file = files.get(key);
      const design = file ? await read(file, files) : null;
      if (!file || !design) break;
      this.#written.set(design, { key, file });
      designs.push(design);
    }
    return designs;
  }

  /** The history about `present`, as far as its steps can be read. */
  async restore(present: Design, keys: StepKeys, files: Files): Promise<History<Design>> {
    const past = await this.#read(keys.past.toReversed(), files);
    const future = await this.#read(keys.future, files);
    return { past: past.reverse(), present, future };
  }
}

// SPDX-License-Identifier: MIT
// The steps before and after the design that autosave keeps, each beside its record: a step never
// changes, so that it is written once.

import type { Shape } from "../solver/protocol.ts";
import type { Design } from "./design.ts";
import type { History } from "./history.ts";
import { isRecord } from "./reading.ts";
import { type KeptFiles, restoreDesign, type StoredDesign } from "./saved-design.ts";
import type { StepKeys } from "./saved-record.ts";

/** Bytes of the steps kept on either side of the design: the nearest. */
const MOST_PAST = 12e6;
const MOST_FUTURE = 4e6;

/** One step in the storage: its key, and about how many bytes it takes. */
interface KeptStep {
  readonly key: string;
  readonly size: number;
}

const newKey = (): string =>
  `step-${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;

const shapeSize = ({ moved, positions }: Shape): number => moved.byteLength + positions.byteLength;

/** About how many bytes a design takes: all but the shapes is small. */
const sizeOf = ({ shape, handles, variation }: Design): number =>
  2000 + 100 * handles.length + shapeSize(shape) + (variation ? shapeSize(variation.centre) : 0);

/** Version 1 packed each step into a file. */
async function read(kept: unknown, files: KeptFiles): Promise<Design | null> {
  if (isRecord(kept) && !(kept instanceof Blob))
    return restoreDesign(kept as unknown as StoredDesign, files);
  if (!(kept instanceof Blob)) return null;
  const { decodeStep } = await import("./v1/record.ts");
  return decodeStep(new Uint8Array(await kept.arrayBuffer()), files);
}

/** The files of the steps of one page. */
export class StepFiles {
  readonly #kept = new WeakMap<Design, KeptStep>();

  #of(design: Design): KeptStep {
    const known = this.#kept.get(design) ?? { key: newKey(), size: sizeOf(design) };
    this.#kept.set(design, known);
    return known;
  }

  /** The `steps`, nearest first, as far as they fit into `most` bytes. */
  #within(most: number, steps: Iterable<Design>): Design[] {
    const all: Design[] = [];
    let left = most;
    for (const step of steps) {
      left -= this.#of(step).size;
      if (left < 0) break;
      all.push(step);
    }
    return all;
  }

  /** What is kept of a history: the steps, their keys, and each by its key. */
  keep({ past, future }: History<Design>) {
    const before = this.#within(MOST_PAST, past.toReversed()).reverse();
    const after = this.#within(MOST_FUTURE, future);
    const all = [...before, ...after];
    const keysOf = (steps: readonly Design[]): string[] => steps.map((step) => this.#of(step).key);
    return {
      designs: all,
      keys: { past: keysOf(before), future: keysOf(after) } satisfies StepKeys,
      steps: new Map(all.map((step) => [this.#of(step).key, step])),
    };
  }

  /** The designs of `keys`, nearest first, up to one that cannot be read. */
  async #read(keys: readonly string[], files: KeptFiles): Promise<Design[]> {
    const designs: Design[] = [];
    for (const key of keys) {
      const design = await read(files.get(key), files);
      if (!design) break;
      this.#kept.set(design, { key, size: sizeOf(design) });
      designs.push(design);
    }
    return designs;
  }

  /** The history about `present`, as far as its steps can be read. */
  async restore(present: Design, keys: StepKeys, files: KeptFiles): Promise<History<Design>> {
    const past = await this.#read(keys.past.toReversed(), files);
    const future = await this.#read(keys.future, files);
    return { past: past.reverse(), present, future };
  }
}

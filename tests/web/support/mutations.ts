// SPDX-License-Identifier: MIT
// Damage, reproducible from a seed: to bytes, and to the JSON inside them.

/** Uniform numbers in [0, 1): mulberry32. */
export function randomFrom(seed: number): () => number {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = state;
    t = Math.imul(t ^ (t >>> 15), t | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

export class Damage {
  readonly #random: () => number;

  constructor(seed: number) {
    this.#random = randomFrom(seed);
  }

  below(count: number): number {
    return Math.floor(this.#random() * count);
  }

  pick<T>(choices: readonly T[]): T {
    const chosen = choices[this.below(choices.length)];
    if (chosen === undefined) throw new Error("nothing to choose from");
    return chosen;
  }

  chance(share: number): boolean {
    return this.#random() < share;
  }

  /** One to four changes: flipped, overwritten, cut, doubled, spliced with `other`, huge counts. */
  bytes(original: Uint8Array, other: Uint8Array): Uint8Array {
    let bytes: Uint8Array = original.slice();
    for (let k = this.below(4); k >= 0; --k) bytes = this.#once(bytes, other);
    return bytes;
  }

  #once(bytes: Uint8Array, other: Uint8Array): Uint8Array {
    const at = this.below(bytes.length + 1);
    switch (this.below(6)) {
      case 0:
        if (at < bytes.length) bytes[at] = (bytes[at] ?? 0) ^ (1 << this.below(8));
        return bytes;
      case 1:
        if (at < bytes.length) bytes[at] = this.pick([0, 1, 0x7f, 0x80, 0xff, this.below(256)]);
        return bytes;
      case 2:
        return bytes.slice(0, at);
      case 3:
        return join(bytes.subarray(0, at), bytes.subarray(Math.max(0, at - this.below(64))));
      case 4:
        return join(bytes.subarray(0, at), other.subarray(this.below(other.length + 1)));
      default: {
        const huge = this.pick([0, 1, 0x7fffffff, 0x80000000, 0xffffffff, bytes.length]);
        if (at + 4 <= bytes.length)
          new DataView(bytes.buffer, bytes.byteOffset).setUint32(at, huge, true);
        return bytes;
      }
    }
  }

  /** Changes a few places of a tree of JSON. */
  json(value: unknown): unknown {
    let changed = structuredClone(value);
    for (let k = this.below(3); k >= 0; --k) changed = this.#inside(changed);
    return changed;
  }

  #inside(value: unknown): unknown {
    if (this.chance(0.2) || typeof value !== "object" || value === null)
      return this.#hostile(value);
    if (Array.isArray(value)) {
      if (value.length === 0 || this.chance(0.1)) return [...value, ...value, this.#hostile(0)];
      const k = this.below(value.length);
      if (this.chance(0.15)) value.splice(k, 1);
      else value[k] = this.#inside(value[k]);
      return value;
    }
    const record = value as Record<string, unknown>;
    const keys = Object.keys(record);
    if (keys.length === 0) return this.#hostile(value);
    const key = this.pick(keys);
    if (this.chance(0.15)) delete record[key];
    else record[key] = this.#inside(record[key]);
    return record;
  }

  #hostile(value: unknown): unknown {
    const number = typeof value === "number" ? value : 1;
    return this.pick<() => unknown>([
      () => null,
      () => true,
      () => -number,
      () => number + 1,
      () => number + 0.5,
      () => 1e308,
      () => -1e308,
      () => 5e-324,
      () => 2 ** 31,
      () => 2 ** 32,
      () => 2 ** 53,
      () => "",
      () => "__proto__",
      () => "constructor",
      () => "<img src=x onerror=alert(1)>",
      () => "x".repeat(this.below(5000)),
      () => [],
      () => ({}),
      () => [[], [[]], {}],
      () => Array.from({ length: this.below(3000) }, (_, k) => k),
      () => nested(this.below(2000)),
      () => JSON.parse('{"__proto__":{"polluted":1},"constructor":{"prototype":{"polluted":1}}}'),
    ])();
  }
}

function nested(depth: number): unknown {
  let value: unknown = 0;
  for (let k = 0; k < depth; ++k) value = [value];
  return value;
}

export function join(a: Uint8Array, b: Uint8Array): Uint8Array {
  const both = new Uint8Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

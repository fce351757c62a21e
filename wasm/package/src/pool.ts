// SPDX-License-Identifier: MIT
// Wasm memory that nobody has to free. Few results are kept there; what was dropped is made again
// when it is asked for, which gives the same bits.
import type { Handle } from "./planish_package.mjs";

const MOST_KEPT = 16;

export class Pool {
  /** The least recently used first. */
  readonly #kept = new Map<object, Handle>();
  /** What cannot be made again: kept as long as its owner lives. */
  readonly #only = new WeakMap<object, Handle>();
  readonly #orphans = new FinalizationRegistry<Handle>((handle) => handle.delete());

  /** The handle of `owner`; `make` must give the same one each time. */
  get<T extends Handle>(owner: object, make: () => T): T {
    const only = this.#only.get(owner);
    if (only) return only as T;
    const handle = (this.#kept.get(owner) as T | undefined) ?? make();
    this.#kept.delete(owner);
    this.#kept.set(owner, handle);
    for (const [oldest, dropped] of this.#kept) {
      if (this.#kept.size <= MOST_KEPT) break;
      this.#kept.delete(oldest);
      dropped.delete();
    }
    return handle;
  }

  /** From now on the handle of `owner` is never made again. */
  keepOnly(owner: object): void {
    const handle = this.#kept.get(owner);
    if (!handle) return;
    this.#kept.delete(owner);
    this.#only.set(owner, handle);
    this.#orphans.register(owner, handle);
  }
}

/** Where the handle of a result is kept; not the result itself, which is not there before super(). */
export class Place<H extends Handle> {
  readonly #pool: Pool;
  readonly #make: () => H;

  constructor(pool: Pool, make: () => H) {
    this.#pool = pool;
    this.#make = make;
  }

  readonly handle = (): H => this.#pool.get(this, this.#make);

  /** A solve that was stopped cannot be made again. */
  keepIfStopped(status: string): void {
    if (status === "cancelled") this.#pool.keepOnly(this);
  }
}

/** What `use` reads from a handle that nobody needs afterwards. */
export function once<T extends Handle, R>(handle: T, use: (handle: T) => R): R {
  try {
    return use(handle);
  } finally {
    handle.delete();
  }
}

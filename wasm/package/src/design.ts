// SPDX-License-Identifier: MIT
// Designs: a base mesh, what was done to it, and the mark of what came out.
import { type Core, loadCore } from "./core.ts";
import { insist } from "./error.ts";
import type { Mesh } from "./mesh.ts";
import type { DesignHandle, ReplayHandle } from "./planish_package.mjs";
import { once, Place } from "./pool.ts";
import { type Progress, Shape } from "./shape.ts";

/** A design done again. */
export class Replay extends Shape {
  /** Whether every bit is the recorded one; null where nothing was recorded. */
  get verified(): boolean | null {
    return this.report.verified ?? null;
  }

  /** Largest distance from the recorded result, model units. */
  get deviation(): number | null {
    return this.report.deviation ?? null;
  }
}

/** A recipe as data. */
export class Design {
  /** One line of JSON with every option spelled out. */
  readonly text: string;
  readonly #core: Core;

  /** @internal Use read() or the design of a result. */
  constructor(core: Core, text: string) {
    const handle = insist(core.module.readDesign(text));
    this.text = handle.text();
    handle.delete();
    this.#core = core;
  }

  /** @param recipe its JSON, or the same as an object @throws PlanishError that names the field */
  static async read(recipe: string | object): Promise<Design> {
    const core = await loadCore();
    return new Design(core, typeof recipe === "string" ? recipe : JSON.stringify(recipe));
  }

  /** Does it again. @param base the mesh, where the design does not hold it */
  replay({ base, progress }: { readonly base?: Mesh; readonly progress?: Progress } = {}): Replay {
    const core = this.#core;
    const again = (): ReplayHandle => {
      const design: DesignHandle = insist(core.module.readDesign(this.text));
      try {
        return insist(design.replay(base?.handle() ?? null, progress ?? null));
      } finally {
        design.delete();
      }
    };
    const place = new Place(core.pool, again);
    const replay = new Replay(
      core,
      (use) => once(place.handle().shape(), use),
      (name) => place.handle().bytes(name),
    );
    place.keepIfStopped(replay.report.status);
    return replay;
  }
}

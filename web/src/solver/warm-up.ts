// SPDX-License-Identifier: MIT
// The browser compiles code well only after it has run a few times, function by function; the
// first frames of the first drag took 30 times the processor time of later ones. So a new solver
// practises on a small sample.
import type { PlanishModule } from "@wasm/planish.mjs";

const SIZE = 7;
/** The middle of the sample. */
const VERTEX = 24;
const FRAMES = 20;

const nextTurn = (): Promise<void> => new Promise((resolve) => setTimeout(resolve, 0));

/** Warms up by one small edit at a time, so that a request never waits for more than that. */
export async function warmUp(planish: PlanishModule): Promise<void> {
  const session = new planish.Session();
  try {
    if (session.openSample("vault", SIZE) !== "") return;
    const base = session.basePositions();
    const pins = new Int32Array(0);
    for (let frame = 1; frame <= FRAMES; ++frame) {
      await nextTurn();
      const { drag, release } = planish.EditMode;
      const [x = 0, y = 0, z = 0] = base.subarray(3 * VERTEX);
      const target = Float64Array.of(VERTEX, x, y, z + 0.05 * frame);
      session.edit(frame < FRAMES ? drag : release, target, pins, 0, 1);
      session.takeChanges();
      session.shapeReport();
    }
  } finally {
    session.delete();
  }
}

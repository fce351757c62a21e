// SPDX-License-Identifier: MIT
// Sliders set at random inside their stops, by the worker's own modules: nothing is spoilt, and made exact the
// bounds still hold.
import type { PlanishModule, Session } from "@wasm/planish.mjs";
import { expect, it } from "vitest";
import { FIRST_SETTINGS } from "../../web/src/design/design.ts";
import type { SliderRange } from "../../web/src/solver/protocol.ts";
import { rangesOf } from "../../web/src/solver/sliders.ts";
import { loadPlanish } from "./support/planish.ts";
import { SolverHere } from "./support/solver-here.ts";

const SIZE = 16;
const SETTINGS = 5;
const DIMENSION = 4;

/** Numbers in 0 … 1 that look random and are the same in every run. */
function numbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** A place between the stops, and within what the slider shows. */
const between = ({ lower, upper }: SliderRange, share: number): number => {
  const [low, high] = [Math.max(-1, lower), Math.min(1, upper)];
  return low + share * (high - low);
};

/** The module, and the sessions that are made with it. */
function watched(module: PlanishModule): { module: PlanishModule; sessions: Session[] } {
  const sessions: Session[] = [];
  const value = new Proxy(module.Session, {
    construct(Real) {
      const session = new Real();
      sessions.push(session);
      return session;
    },
  });
  return { module: Object.create(module, { Session: { value } }), sessions };
}

it.each(["roof", "vault", "dome", "hex"])(
  "hold on a %s",
  async (name) => {
    const { module, sessions } = watched(await loadPlanish());
    const solver = new SolverHere(module);
    const { positions, offsets, vertices, report } = await solver.openSample(name, SIZE);
    const middle = [...positions.keys()].filter((k) => k % 3 === 0).map((k) => k / 3);
    const away = (v: number): number =>
      Math.hypot(...report.centre.slice(0, 2).map((c, axis) => (positions[3 * v + axis] ?? 0) - c));
    const vertex = middle.reduce((best, v) => (away(v) < away(best) ? v : best), 0);
    const [x = 0, y = 0, z = 0] = positions.subarray(3 * vertex);
    const edit = await solver.ask(
      {
        kind: "edit",
        job: 2,
        mode: "solve",
        targets: { handles: [vertex, x, y, z + 0.5 * report.meanEdge], pins: [] },
        settings: FIRST_SETTINGS,
        budget: 0,
        limit: null,
        reaches: [],
        sought: null,
      },
      "shown",
    );
    const explored = {
      kind: "explore",
      job: 3,
      family: { asked: DIMENSION, eigenbasis: false },
    } as const;
    const { leads } = await solver.ask(explored, "explored");
    expect(leads.length).toBeGreaterThan(0);
    const { Analysis } = await loadPlanish();
    const analysis = new Analysis(positions, offsets, vertices, new Float64Array(0));
    const [{ shape }, [session]] = [edit, sessions];
    if (!shape || !session) throw new Error("no shape");
    const [support, moves] = [session.variationSupport(), session.variationDisplacements()];
    analysis.setFamily(shape.moved, shape.positions, support, moves);
    const spoilt = (moved: Int32Array, at: Float64Array): number => {
      analysis.show(moved, at);
      // A new sliver, 5, is sound.
      return analysis.panelDamage().filter((kind) => kind > 0 && kind < 5).length;
    };
    expect(spoilt(shape.moved, shape.positions)).toBe(0);
    const random = numbers(7);
    for (let setting = 0; setting < SETTINGS; ++setting) {
      // One slider after the other, each within the stops that those before it leave.
      const values = new Float64Array(leads.length);
      for (let k = 0; k < leads.length; ++k) {
        const range = rangesOf(analysis.sliderStops(values))[k];
        if (range) values[k] = between(range, random());
      }
      const coefficients = [...values];
      await solver.ask({ kind: "vary", job: 4, coefficients }, "shown");
      expect(spoilt(session.moved(), session.movedPositions()), `${coefficients}`).toBe(0);
      const exact = await solver.ask({ kind: "project", job: 5, coefficients }, "projected");
      expect(spoilt(exact.shape.moved, exact.shape.positions), `${coefficients}`).toBe(0);
      expect(exact.report.worstExcess).toBeLessThanOrEqual(1e-6);
    }
  },
  60_000,
);

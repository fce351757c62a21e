// SPDX-License-Identifier: MIT
// The scenes of the paper's figures: which mesh, which point, which move. Everything else that a
// scene holds is computed from this by the command line.
//
// `at` is where the handle sits, as shares of the mesh's extent in plan; `move` is in mean edges.

/** Figures that compare methods, or weights, state the paper's problem, which knows no bound on the
 * panels' shape; the others show what the product makes. */
const PURE_FIGURES = new Set([2, 3, 7]);
const figureOf = (name) => Number(/^figure-(\d)/.exec(name)[1]);

/** An edit; `variation` makes it a place in a family of variations around that edit. */
const scene = (name, label, mesh, pulls, { variation = null, ...options } = {}) => ({
  name,
  figure: figureOf(name),
  keepShape: !PURE_FIGURES.has(figureOf(name)),
  label,
  mesh,
  pulls,
  options,
  variation,
});

const MIDDLE = [0.5, 0.5];
const DOME = "dome:32";
const DOME_LIFT = [{ vertex: 528, move: [0, 0, 1.0653] }]; // 1.5 model units, the public scene

const roof = (name, label, variation) =>
  scene(name, label, "freeform:28", [{ at: [0.46, 0.48], move: [0, 0, 1.6] }], {
    smoothness: 6,
    variation,
  });

const SHELL = "freeform:32";
const CROWN = { at: [0.55, 0.55], move: [0, 0, 1.5] };
const FLANK = { at: [0.3, 0.35], move: [0.5, -0.5, -1.0] };

const shell = (name, label, options) => scene(name, label, SHELL, [CROWN], options);

const varied = (name, label, pull, variation) =>
  scene(name, label, SHELL, [pull], { smoothness: 4, variation });

export const SCENES = [
  roof("figure-1", "a glass roof, its central zone changed", [0.7, -0.4, 0.3, 0]),

  shell("figure-2-l21", "few points move", {}),
  shell("figure-2-l2", "an ℓ2 closeness term at equal fairness", { equalFairness: "l2" }),
  shell("figure-2-region", "a fixed region at equal fairness", { equalFairness: "region" }),

  shell("figure-3-a", "no fairness, as [Hof10]", { smoothness: 0 }),
  shell("figure-3-b", "fairness weight 1", { smoothness: 1 }),
  shell("figure-3-c", "fairness weight 10", { smoothness: 10 }),
  shell("figure-3-d", "fairness weight 100", { smoothness: 100 }),

  varied("figure-4-edit", "the edit", CROWN, null),
  varied("figure-4-t1", "first basis vector added", CROWN, [0.5, 0, 0, 0]),
  varied("figure-4-t2", "second", CROWN, [0, 0.5, 0, 0]),
  varied("figure-4-t3", "third", CROWN, [0, 0, 0.5, 0]),
  varied("figure-4-t4", "fourth", CROWN, [0, 0, 0, 0.5]),
  varied("figure-4-mix-a", "a combination", CROWN, [0.6, 0.5, -0.3, 0.2]),
  varied("figure-4-mix-b", "another combination", CROWN, [-0.5, 0.3, 0.4, -0.4]),

  roof("figure-5-a", "an edit", null),
  roof("figure-5-a1", "varied", [0.8, 0, 0, 0]),
  roof("figure-5-a2", "varied", [-0.8, 0.4, 0, 0]),
  roof("figure-5-a3", "varied", [0, -0.6, 0.6, 0]),
  varied("figure-5-b", "another edit", FLANK, null),
  varied("figure-5-b1", "varied", FLANK, [0.7, 0.3, 0, 0]),
  varied("figure-5-b2", "varied", FLANK, [-0.7, 0, 0.3, 0]),
  varied("figure-5-b3", "varied", FLANK, [0, 0.5, -0.5, 0.2]),

  roof("figure-6-a", "projected", [1, 0.8, -0.6, 0.4]),
  varied("figure-6-b", "projected", FLANK, [1, -0.9, 0.6, 0]),

  scene("figure-7", "by the reference solver", DOME, DOME_LIFT, { solver: "alm" }),

  scene("figure-8-a", "a tri-hex shell, raised", "trihex:32", [{ at: MIDDLE, move: [0, 0, 1] }]),
  scene("figure-8-b", "pushed aside", "trihex:32", [{ at: [0.3, 0.6], move: [0.5, 0.5, -0.7] }]),
  scene("figure-9-a", "a hexagonal shell, raised", "hex:32", [{ at: MIDDLE, move: [0, 0, 1] }]),
  scene("figure-9-b", "pushed aside", "hex:32", [{ at: [0.35, 0.4], move: [0.5, 0.5, -0.7] }]),
];

/** The one of each figure that the page's chooser offers. */
export const OFFERED = new Map([
  ["figure-1", "Glass roof, changed in the middle"],
  ["figure-2-l21", "Few points move"],
  ["figure-3-d", "A wide edit"],
  ["figure-4-mix-a", "A variation of an edit"],
  ["figure-5-b1", "Another edit varied"],
  ["figure-6-a", "Made exact"],
  ["figure-7", "By the reference solver"],
  ["figure-8-a", "Triangles and hexagons"],
  ["figure-9-a", "Hexagons"],
]);

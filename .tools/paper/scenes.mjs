// SPDX-License-Identifier: MIT
// The scenes of the paper's figures: which mesh, which point, which move. Everything else that a
// scene holds is computed from this by the command line.
//
// `at` is where the handle sits, as shares of the mesh's extent in plan; `move` is in mean edges.

/** An edit; `variation` makes it a place in a family of variations around that edit. */
const scene = (name, label, mesh, pulls, { variation = null, ...options } = {}) => ({
  name,
  figure: Number(/^figure-(\d)/.exec(name)[1]),
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

const dome = (name, label, options) => scene(name, label, DOME, DOME_LIFT, options);

const shell = (name, label, pull, variation) =>
  scene(name, label, "freeform:32", [pull], { smoothness: 4, variation });
const CROWN = { at: [0.55, 0.55], move: [0, 0, 1.4] };
const FLANK = { at: [0.3, 0.35], move: [0.5, -0.5, -1.0] };

export const SCENES = [
  roof("figure-1", "a glass roof, its central zone changed", [0.7, -0.4, 0.3, 0]),

  dome("figure-2-l21", "few points move", {}),
  dome("figure-2-l2", "an ℓ2 closeness term at equal fairness", { equalFairness: "l2" }),
  dome("figure-2-region", "a fixed region at equal fairness", { equalFairness: "region" }),

  dome("figure-3-a", "no fairness, as [Hof10]", { smoothness: 0 }),
  dome("figure-3-b", "fairness weight 1", { smoothness: 1 }),
  dome("figure-3-c", "fairness weight 10", { smoothness: 10 }),
  dome("figure-3-d", "fairness weight 100", { smoothness: 100 }),

  dome("figure-4-edit", "the edit", {}),
  dome("figure-4-t1", "first basis vector added", { variation: [1, 0, 0, 0] }),
  dome("figure-4-t2", "second", { variation: [0, 1, 0, 0] }),
  dome("figure-4-t3", "third", { variation: [0, 0, 1, 0] }),
  dome("figure-4-t4", "fourth", { variation: [0, 0, 0, 1] }),
  dome("figure-4-mix-a", "a combination", { variation: [0.6, 0.5, -0.3, 0.2] }),
  dome("figure-4-mix-b", "another combination", { variation: [-0.5, 0.3, 0.4, -0.4] }),

  shell("figure-5-a", "raised at the crown", CROWN),
  shell("figure-5-a1", "variation", CROWN, [0.6, 0, 0.2, 0]),
  shell("figure-5-a2", "variation", CROWN, [-0.4, 0.5, 0, 0]),
  shell("figure-5-a3", "variation", CROWN, [0, -0.4, 0.4, 0.3]),
  shell("figure-5-b", "pushed in on the flank", FLANK),
  shell("figure-5-b1", "variation", FLANK, [0.5, 0.3, 0, 0]),
  shell("figure-5-b2", "variation", FLANK, [-0.5, 0, 0.3, 0]),
  shell("figure-5-b3", "variation", FLANK, [0, 0.4, -0.4, 0.2]),

  dome("figure-6-a", "projected", { smoothness: 4, variation: [0.9, -0.6, 0, 0] }),
  shell("figure-6-b", "projected", CROWN, [0.9, 0.6, -0.4, 0]),

  dome("figure-7", "by the reference solver", { solver: "alm" }),

  scene("figure-8-a", "a tri-hex shell, raised", "trihex:32", [{ at: MIDDLE, move: [0, 0, 1] }]),
  scene("figure-8-b", "pushed aside", "trihex:32", [{ at: [0.35, 0.6], move: [0.4, 0.4, -0.6] }]),
  scene("figure-9-a", "a hexagonal shell, raised", "hex:32", [{ at: MIDDLE, move: [0, 0, 1] }]),
  scene("figure-9-b", "pushed aside", "hex:32", [{ at: [0.4, 0.35], move: [0.4, 0.4, -0.6] }]),
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

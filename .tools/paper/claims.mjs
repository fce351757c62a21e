// SPDX-License-Identifier: MIT
// The paper's claims beside what was measured. The verdict follows from the figures.
const short = (x) => Number(Number(x).toPrecision(3)).toString();
const times = (a, b) => `${short(a / b)} ×`;
const verdict = (holds) => (holds ? "holds" : "differs");

/** Of a claim that is counted over cases: whether its sentence is true of each of them. */
const holdsEverywhere = (c) => c.holds && (c.cases === undefined || c.holding === c.cases);
const ofCases = (c) => `${c.holding} of ${c.cases} cases`;
const test = (name) => `test \`PaperClaim.${name}\``;

/** Where, what, the test of tests/paper/claims_test.cpp, and its records as words. */
const TESTED = [
  [
    "Prop. 1 (b)",
    "D(u, v) ≥ c ξ(u, v)",
    "PropositionOneBoundsTheGap",
    (c) =>
      `smallest D / (c ξ) of ${c.random_pairs} random pairs and ${c.pairs - c.random_pairs} edits with a variation each: ${short(c.smallest_gap_over_bound)}`,
  ],
  [
    "Prop. 1 (a)",
    "D = 0 exactly where ξ = 0",
    "GapVanishesExactlyWithTheCorrelation",
    (c) =>
      `disjoint pairs: at most ${short(c.largest_gap_of_disjoint_pairs)}; one shared vertex: at least ${short(c.smallest_gap_of_touching_pairs)}`,
  ],
  [
    "App. A",
    "‖u‖‖v‖ = ¼ ∮ (‖xu‖ + ‖yv‖)² − ‖xu + yv‖²",
    "TheIdentityOfAppendixA",
    (c) =>
      `largest relative difference ${short(c.largest_difference)}, of random pairs and of ξ as ${c.variations} variations report it`,
  ],
  [
    "Sec. 2.1",
    "d ≈ 2 N_V on quads and tri-hex, 1.5 N_V on hexagons",
    "DegreesOfFreedomPerVertexApproachTheCountsOfTheRegularMeshes",
    (c) =>
      `at 128²: quads ${short(c.vault_128)}, tri-hex ${short(c.trihex_128)}, hexagons ${short(c.hex_128)}; larger on small meshes, by their boundary`,
  ],
  [
    "Sec. 2.1",
    "the count is the dimension of the tangent space",
    "TangentSpaceHasTheCountedDimension",
    (c) =>
      `rank of J against the count: ${["vault", "dome", "freeform", "trihex", "hex"].map((name) => `${name} ${c[`${name}_tangent`]} and ${c[`${name}_counted`]}`).join(", ")}`,
  ],
  [
    "Fig. 3",
    "the modification grows with every larger ω_f",
    "EditsBesideTheFairnessWeight",
    (c) =>
      `${ofCases(c)} (five samples, two lifts); at ω_f = 0 no more than the one ring in ${c.one_ring}. Points visibly moved at ω_f = 0, 0.1, 1, 10, lift 1 edge: ${["vault", "dome", "freeform", "trihex", "hex"].map((name) => `${name} ${c[name]}`).join("; ")}`,
  ],
  [
    "Fig. 9",
    "hexagons move a larger region than tri-hex",
    "RegionsOfHexagonsBesideTriHex",
    (c) => `${ofCases(c)} (four sizes, seven lifts in mean edges, points visibly moved)`,
  ],
  [
    "Sec. 2.2",
    "basis of no more than 1 % of the tangent space",
    "FourVectorsAreAFractionOfTheTangentSpace",
    (c) =>
      `families of ${c.vault_dimension} and ${c.dome_dimension}, solved for: ${short(100 * c.vault_share)} % and ${short(100 * c.dome_share)} % of the count`,
  ],
  [
    "Fig. 6",
    "projection brings explored meshes within 10 mm/m",
    "ProjectionBringsAnExploredMeshWithinTheFabricationLimit",
    (c) => `${short(c.before_mm_per_m)} before, ${short(c.after_mm_per_m)} mm/m after`,
  ],
  [
    "Sec. 3.5",
    "the printed algorithm meets fabrication tolerance at 1 K vertices",
    "TheReferenceAlgorithmConvergesToFabricationTolerance",
    (c) =>
      `vault ${short(c.vault_mm_per_m)} mm/m after ${c.vault_steps} inner steps, dome ${short(c.dome_mm_per_m)} after ${c.dome_steps}`,
  ],
  [
    "Sec. 4",
    "ℓ2,1 “may not completely prevent small vertex displacements”",
    "TheReferenceAlgorithmConvergesToFabricationTolerance",
    (c) =>
      `as printed ${c.dome_moved} points of the dome move, ${c.dome_visibly_moved} visibly; our engines take the support from y and leave the rest bit-identical`,
  ],
  [
    "Sec. 3.6",
    "one inner step (ADMM) may fail where several converge",
    "SeveralInnerStepsConvergeWhereAdmmDoesNot",
    (c) =>
      `of ${c.scenes} edits within 4,500 inner steps: ${c.converged_with_30_inner_steps} with l_max = 30, ${c.converged_with_1_inner_step} with 1. Where ADMM does end, its objective is as low or lower`,
  ],
  [
    "Sec. 4",
    "without the correlation term vectors leave the edit",
    "WithoutTheCorrelationTermVectorsLeaveTheEdit",
    (c) =>
      `share of their length outside: vault ${short(c.vault_outside_with)} → ${short(c.vault_outside_without)}, dome ${short(c.dome_outside_with)} → ${short(c.dome_outside_without)}`,
  ],
  [
    "Sec. 1.2",
    "solving (3) itself works for larger moves than [HK12]",
    "GreedyLinearisationFailsForLargerMoves",
    (c) =>
      `flat and no edge more than three times as long, of ${c.moves} edits: greedy ${c.usable_greedy}, ours ${c.usable_ours}`,
  ],
];

function testedRows(claims) {
  return TESTED.map(([paper, statement, name, measured]) => {
    const claim = claims[name];
    if (!claim) throw new Error(`tests/paper has no PaperClaim.${name}`);
    return [statement, paper, measured(claim), verdict(holdsEverywhere(claim)), test(name)];
  });
}

/** Rows about time: processor time within one run, never asserted by a test. */
function timedRows({ times: runs, methods }) {
  const rows = [];
  const slowest = Math.max(...["vault", "dome"].map((name) => methods[name].alm.processor_seconds));
  const fastest = Math.max(
    ...["vault", "dome"].map((name) => methods[name].newton.processor_seconds),
  );
  rows.push([
    "an edit at 1 K vertices converges within a few seconds",
    "Sec. 3.5 (quad core, 2013)",
    `as printed ${short(slowest)} s on one core; our second engine ${short(1000 * fastest)} ms, panels flat to rounding`,
    verdict(slowest < 5),
    "`planish compare alm`",
  ]);
  for (const engine of ["reference", "newton"]) {
    const own = ["vault", "dome"].map((name) => runs[name][engine]);
    const perVector = own.map((m) => m.family.processor_seconds / m.family.dimension);
    const ratios = own.map((m, k) => perVector[k] / m.processor_seconds);
    const projections = own.map((m) => m.projection.processor_seconds / m.processor_seconds);
    const name = engine === "reference" ? "reference engine" : "second engine";
    rows.push([
      `a basis vector costs about as much as an edit (${name})`,
      "Sec. 3.5",
      `vault ${times(perVector[0], own[0].processor_seconds)}, dome ${times(perVector[1], own[1].processor_seconds)}`,
      verdict(ratios.every((x) => x > 0.5 && x < 2)),
      "`planish compare … --dimension 4`",
    ]);
    rows.push([
      `projection is cheaper than an edit (${name})`,
      "Sec. 3.5",
      `vault ${short(projections[0])} ×, dome ${short(projections[1])} ×${engine === "newton" ? ": our edit works on a few dozen points, the projection on the whole explored region" : ""}`,
      verdict(projections.every((x) => x < 1)),
      "`planish compare … --dimension 4`",
    ]);
  }
  return rows;
}

/** Fig. 2, from the scenes themselves. */
function closenessRows({ closeness }) {
  const [sparse, square, region] = closeness;
  const label = "figure 2";
  return [
    [
      "more local than ℓ2 closeness at equal fairness",
      "Fig. 2",
      `‖Ed‖² ${short(sparse.fairness)} and ${short(square.fairness)}: ${sparse.visibly_moved} against ${square.visibly_moved} points visibly moved`,
      verdict(sparse.visibly_moved < square.visibly_moved),
      label,
    ],
    [
      "less distortion than a fixed region at equal fairness",
      "Fig. 2",
      `‖Ed‖² ${short(sparse.fairness)} and ${short(region.fairness)}: Σ‖d_i‖ ${short(sparse.displacement_l21)} against ${short(region.displacement_l21)}, fold change ${short(sparse.fold_change_degrees)}° against ${short(region.fold_change_degrees)}°, edge strain ${short(100 * sparse.edge_strain)} % against ${short(100 * region.edge_strain)} %`,
      verdict(
        sparse.displacement_l21 <= region.displacement_l21 &&
          sparse.fold_change_degrees <= region.fold_change_degrees &&
          sparse.edge_strain <= region.edge_strain,
      ),
      label,
    ],
  ];
}

export const claimRows = (measured) => [
  ...testedRows(measured.claims),
  ...closenessRows(measured),
  ...timedRows(measured),
];

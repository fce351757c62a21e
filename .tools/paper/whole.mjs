// SPDX-License-Identifier: MIT
// One run: measures, pictures, and docs/paper.md from them.
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { claimRows } from "./claims.mjs";
import { ROOT } from "./command.mjs";
import { coverage } from "./ledger.mjs";
import { METHODS, measure } from "./measuring.mjs";
import { writePictures } from "./pictures.mjs";

const table = (head, rows) =>
  [head, head.map(() => "---"), ...rows].map((row) => `| ${row.join(" | ")} |`).join("\n");

/** Three significant digits. */
const short = (x) => (x === 0 ? "0" : Number(x.toPrecision(3)).toString());
const milliseconds = (seconds) => `${short(1000 * seconds)} ms`;

const FIGURES = {
  1: "Local modification of a glass roof: before, and a variation of its central zone made exact.",
  2: "ℓ2,1 against an ℓ2 closeness term and against a fixed region, at equal fairness.",
  3: "Growing fairness weight ω_f: 0, 1, 10 and 100.",
  4: "A subspace of four vectors: the edit, each vector added to it, and two combinations.",
  5: "Two edits, each with three combinations of its own four vectors.",
  6: "Two explored meshes before and after projection. Colour: planarity, dark from 10 mm/m on.",
  7: "The solver's stages: an edit by the reference engine, its residuals and its penalty.",
  8: "A planar tri-hex mesh.",
  9: "A planar hexagonal mesh; edits of equal size are compared with tri-hex in the claims above.",
};

const spoiltIn = ({ figures }) => Object.entries(figures.spoilt_faces);

/** "4 turned over, 4 concave" */
const spoiltWords = (entry) =>
  spoiltIn(entry)
    .map(([damage, faces]) => `${faces.length} ${damage}`)
    .join(", ") || "none";

/** That the scenes are the paper's problem, and what that does. */
function pureProblem(scenes) {
  const spoilt = scenes.filter((entry) => spoiltIn(entry).length > 0);
  const pure = scenes.filter(({ scene }) => !scene.keepShape);
  return `Figures that compare methods or weights (${pure.length} of the ${scenes.length} scenes) state the paper's pure problem, which has
no bound on the panels' shape (\`--bound shape=off\`); the others keep it, as the product does by default. Every
panel is flat; ${spoilt.length} scenes spoil some, which nobody would build. The tables say which.`;
}

function gallery(scenes) {
  return Object.entries(FIGURES).map(([figure, caption]) => {
    const own = scenes.filter(({ scene }) => scene.figure === Number(figure));
    const rows = own.map(({ scene, moved, figures, link }) => [
      scene.label,
      scene.mesh,
      `${moved} of ${figures.mesh.vertices}`,
      spoiltWords({ figures }),
      `[recipe](scenes/${scene.name}.json) · [open](http://localhost:4173/${link})`,
    ]);
    const what = ["scene", "mesh", "points moved", "panels spoilt", "design"];
    return `### Figure ${figure}\n\n${caption}\n\n![Figure ${figure}: ${caption}](pictures/figure-${figure}.png)\n\n${table(what, rows)}\n`;
  });
}

const METHOD_NAMES = {
  newton: "**ours, newton** (3)",
  reference: "ours, reference engine with exact finish (3)",
  alm: "Sec. 3 as printed, l_max = 30",
  admm: "the same with l_max = 1 (ADMM)",
  hof10: "[Hof10] one ring",
  hk12: "[HK12] greedy, linearised, reprojected",
  shapeup: "[BDS*12] Shape-Up",
  yypm11: "[YYPM11] tangent space, reprojected",
};

function methodTable(results) {
  const head = ["method", "points moved", "visibly", "‖Ed‖²", "Σ‖d_i‖", "worst panel, mm/m"];
  return table(
    [...head, "handle off", "largest edge strain", "time", "finished"],
    METHODS.map((method) => {
      const m = results[method];
      return [
        METHOD_NAMES[method],
        m.moved_vertices,
        m.visibly_moved,
        short(m.fairness),
        short(m.displacement_l21),
        m.planarity_mm_per_m.toExponential(0),
        short(m.handle_error),
        `${short(100 * m.edge_strain)} %`,
        milliseconds(m.processor_seconds),
        m.finished ? "yes" : "no",
      ];
    }),
  );
}

const SIMPLIFIED = `- **[Hof10]**: what the paper says of it (the handle on its target, the one ring follows, nothing else
  moves). Hoffmann moves the planes of faces; here the ring's vertices take the shortest Newton steps,
  the handle coming in eight parts.
- **[HK12]**: block-orthogonal matching pursuit for the fewest vertices that satisfy the linearised
  constraints, then Newton steps onto the true ones on that set. Few vertices is all it asks for, so the
  ones that it finds may have to move far: see the edge strain.
- **[BDS\\*12]**: local projections and a global step with planarity as a soft term of the handles'
  weight, ω_f ‖Ed‖² for smoothness, at most 2,000 steps; the boundary is held, since without an anchor
  the whole mesh would follow the handle.
- **[YYPM11]**: first order only (no osculants); the fairest displacement of the tangent space that
  follows the handle with the boundary held, then Newton steps onto the constraints.
- "Visibly" means by more than 1/1000 of the handle's pull. Strain is the largest relative change of an
  edge's length. Times are processor time of one thread on a machine that did other things too.`;

const DIFFERENCES = `### Where we differ, and why

- **Fixed region.** The paper shows that a region fixed by hand distorts more. In our measure the region
  moves its points farther in all (Σ‖d_i‖), but what each edge and fold suffers can be less: a region
  without a sparsity term spreads the same pull evenly. Where the paper's own picture comes from is not
  published, so this stays a difference.
- **Projection.** The paper's (8) is a smooth problem solved to fabrication tolerance. Ours keeps the
  weighted distance Σ w_i ‖t̃_i‖, so that what has not moved stays bit-identical, and ends at 1e-6 mm/m;
  and it works on the whole explored region, several times the edit. So it costs more than an edit.
- **Locality.** As printed, nearly every vertex moves a little. Both engines of the product take the
  support from y and drop the rest exactly, which costs a little of the objective.
- **ADMM.** It meets both residuals less often within the same number of steps, as the paper says; where
  it gets there, its local minimum is not worse. The problem is non-convex, and each way ends in its own.
- **Exploring under inequalities.** The paper leaves it open. Along a slider a corner's share of its shape is a
  quadratic ([SUB-7](math.md)), so every slider has stops in closed form, new ones whenever another slider moves;
  what is made exact between them keeps the bounds (test \`tests/parity/slider-stops.test.ts\`).
- **Figures 3 and 9.** Our edits are minima of a non-convex problem: with a larger ω_f, or on hexagons, the
  lowest one that is found is at times narrower. The rows above say in how many cases.
- **Sec. 3.5, parallel steps.** x, y and z share one factor, as printed. The projections of the faces, the shrinkage of the
  vertices and the solve run on threads natively (\`--threads N\`); in the solve subtrees of the elimination tree run side by
  side, all three coordinates at once, in place of a thread for each coordinate. Factorizations run on one.
- **Lengths and times.** The paper's meshes and parameters are not published: shapes agree in kind, not
  in number. Its times are of a quad core of 2013, ours of one core.`;

function closenessTable(rows) {
  return table(
    ["closeness", "‖Ed‖²", "points visibly moved", "Σ‖d_i‖", "largest strain", "fold change"],
    rows.map((m) => [
      m.scene.label,
      short(m.fairness),
      m.visibly_moved,
      short(m.displacement_l21),
      `${short(100 * m.edge_strain)} %`,
      `${short(m.fold_change_degrees)}°`,
    ]),
  );
}

function familyTable(times) {
  const row = (name, family) => [
    name,
    family.visibly_moved.join(", "),
    family.correlation.map((x) => x.toFixed(2)).join(", "),
    milliseconds(family.processor_seconds / family.dimension),
  ];
  const rows = Object.entries(times).flatMap(([name, { newton, reference }]) => [
    row(`${name}: ours, newton (7)`, newton.family),
    row(`${name}: ours, Appendix B (7)`, reference.family),
    row(`${name}: global [YYPM11]`, newton.global_family),
  ]);
  return table(["family", "points visibly moved", "ξ with the edit", "time per vector"], rows);
}

function agreementText({ agreement }) {
  if (!agreement) return "There is no committed benchmark run of this machine to compare with.";
  const rows = agreement.rows.map(({ name, objective, moved, seconds, benchmark }) => [
    name,
    `${objective.toFixed(2)} / ${benchmark.objective.toFixed(2)}`,
    `${moved} / ${benchmark.moved}`,
    `${milliseconds(seconds)} / ${short(benchmark.ms)} ms`,
  ]);
  const head = ["public scene", "objective here / there", "points moved", "one edit"];
  return `${agreement.agree ? "This run and the benchmark run of the same machine agree" : "**This run and the benchmark run of the same machine differ**"} (\`docs/benchmarks/${agreement.file}\`; here with set-up):\n\n${table(head, rows)}`;
}

function ledgerTable() {
  const head = ["equation", "what", "ledger keys", "functions", "tests"];
  return table(
    head,
    coverage().map(({ equation, what, keys, code, tests }) => [
      equation,
      what,
      keys.join(", "),
      code,
      tests,
    ]),
  );
}

function page(scenes, measured) {
  const apart = Math.max(...scenes.map(({ deviation }) => deviation));
  const claims = claimRows(measured);
  const held = claims.filter(([, , , verdict]) => verdict === "holds").length;
  return `# The paper, figure by figure and claim by claim

Deng et al. 2013, *Exploring Local Modifications for Constrained Meshes*, measured with this code on
${measured.machine}, ${measured.date}. This page, its pictures, recipes and links are made by
\`node .tools/paper/paper.mjs\` from nothing; no figure in it is typed. \`npm start\` serves the page that the
links open (port 4173); the Sample list there offers one scene of each figure. Each link was opened in
a real browser in this run and said "Verified"; a test does it again. The meshes are our own samples that
resemble the paper's, which were never published.

## Claims

${held} of ${claims.length} hold as stated; the others say what differs.

${table(["claim", "paper", "measured", "verdict", "where"], claims)}

${DIFFERENCES}

## Other methods on the same edit

Public scenes of [math.md](math.md), 1,024 vertices, one vertex lifted by 1.5.
\`planish compare METHOD MESH …\` runs each.

**Dome**

${methodTable(measured.methods.dome)}

**Vault**

${methodTable(measured.methods.vault)}

${SIMPLIFIED}

### At equal fairness (Figure 2)

${closenessTable(measured.closeness)}

The ℓ2 weight is searched until ‖Ed‖² is the same; the region is the number of face rings whose ‖Ed‖²
is nearest, so it is equal only roughly.

### Families of variations

${familyTable(measured.times)}

## Figures

Points that moved are blue, deeper the farther they went.

${pureProblem(scenes)}

${gallery(scenes).join("\n")}
## Equations

Every equation that the paper numbers or sets apart, by the rows of [math.md](math.md); this page is not
written if one has no code or no test.

${ledgerTable()}

## Agreement

${agreementText(measured)}

The command line and the browser differ in rounding: the ${scenes.length} scenes above agree to
${apart.toExponential(0)} m. A recipe's mark is the command line's (\`planish replay\` verifies it to the
last bit), a link's mark is the browser's. The page opens recipes too (Open file) and
says by how much its result differs.
`;
}

export async function writePaper(scenes) {
  const measured = measure(scenes);
  await writePictures(scenes, measured);
  writeFileSync(join(ROOT, "docs/paper.md"), page(scenes, measured));
  console.log("docs/paper.md");
  const disagrees = measured.agreement && !measured.agreement.agree;
  if (disagrees) console.error("paper: the benchmark run of this machine says otherwise");
  return !disagrees && Object.values(measured.claims).every((claim) => claim.holds);
}

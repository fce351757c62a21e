// SPDX-License-Identifier: MIT
// From a scene's few words to a recorded design: docs/scenes/<name>.json.
import { design, planish, report } from "./command.mjs";

const meshes = new Map();

/** Vertices and faces of a sample, and its mean edge. */
export function sampleMesh(name) {
  const known = meshes.get(name);
  if (known) return known;
  const [sample, size] = name.split(":");
  const rows = planish("sample", sample, "--size", size, "-o", "-").split("\n");
  const points = rows
    .filter((row) => row.startsWith("v "))
    .map((row) => row.slice(2).split(" ").map(Number));
  const faces = rows
    .filter((row) => row.startsWith("f "))
    .map((row) =>
      row
        .slice(2)
        .split(" ")
        .map((corner) => Number.parseInt(corner, 10) - 1),
    );
  const edge = report("info", `sample:${name}`).mesh.mean_edge;
  const mesh = { points, faces, edge };
  meshes.set(name, mesh);
  return mesh;
}

/** The vertex nearest to shares of the extent in plan. */
function vertexAt({ points }, shares) {
  const range = (axis) => {
    const values = points.map((p) => p[axis]);
    return [Math.min(...values), Math.max(...values)];
  };
  const aim = [0, 1].map((axis) => {
    const [low, high] = range(axis);
    return low + shares[axis] * (high - low);
  });
  const distance = (p) => Math.hypot(p[0] - aim[0], p[1] - aim[1]);
  return points.reduce((best, p, v) => (distance(p) < distance(points[best]) ? v : best), 0);
}

/** Vertices more than `rings` face rings away from `vertex`. */
function beyond({ points, faces }, vertex, rings) {
  let inside = new Set([vertex]);
  for (let ring = 0; ring < rings; ++ring) {
    inside = new Set(
      faces
        .filter((face) => face.some((v) => inside.has(v)))
        .flat()
        .concat([...inside]),
    );
  }
  return points.map((_, v) => v).filter((v) => !inside.has(v));
}

/** The handles of a scene: vertex, and its move in model units. */
export function handles({ mesh, pulls }) {
  const sample = sampleMesh(mesh);
  return pulls.map(({ at, vertex, move }) => ({
    vertex: vertex ?? vertexAt(sample, at),
    move: move.map((x) => Number((x * sample.edge).toPrecision(4))),
  }));
}

const WORDS = {
  smoothness: "--smoothness",
  locality: "--locality",
  solver: "--solver",
  sparsity: "--sparsity",
};

/** The words that pose a scene's edit, without its command. */
export function editWords(scene, options = scene.options) {
  const words = [`sample:${scene.mesh}`];
  if (!scene.keepShape) words.push("--bound", "shape=off"); // the paper's pure problem
  for (const { vertex, move } of handles(scene))
    words.push("--handle", `${vertex}+=${move.join(",")}`);
  for (const [name, word] of Object.entries(WORDS)) {
    if (options[name] !== undefined) words.push(word, String(options[name]));
  }
  if (options.pins) words.push("--pin", options.pins.join(","));
  return words;
}

export const compare = (method, scene, options) =>
  report("compare", method, ...editWords(scene, options));

/** ω_s of the ℓ2 term that gives `fairness`: larger weights are more local and less fair. */
function closenessFor(scene, fairness) {
  let [low, high] = [1e-4, 1e4];
  for (let step = 0; step < 20; ++step) {
    const middle = Math.sqrt(low * high);
    const found = compare("newton", scene, { sparsity: "l2", locality: middle });
    if (found.fairness < fairness) low = middle;
    else high = middle;
  }
  return Number(Math.sqrt(low * high).toPrecision(6));
}

/** The pins of the region, in face rings around the handle, whose fairness is nearest. */
function regionFor(scene, fairness) {
  const [{ vertex }] = handles(scene);
  const tried = [2, 3, 4, 5, 6].map((rings) => {
    const pins = beyond(sampleMesh(scene.mesh), vertex, rings);
    const found = compare("newton", scene, { locality: 0, pins });
    return { pins, gap: Math.abs(Math.log(found.fairness / fairness)) };
  });
  return tried.reduce((best, next) => (next.gap < best.gap ? next : best)).pins;
}

/** A scene's options with what has to be searched for. */
export function settled(scene) {
  const { equalFairness, ...options } = scene.options;
  if (!equalFairness) return options;
  const { fairness } = compare("newton", scene, options);
  return equalFairness === "l2"
    ? { ...options, sparsity: "l2", locality: closenessFor(scene, fairness) }
    : { ...options, locality: 0, pins: regionFor(scene, fairness) };
}

/** The recorded design of a scene, with the report of the run that made it. */
export function record(scene) {
  const options = settled(scene);
  const words = editWords(scene, options);
  const run = scene.variation
    ? design(
        "explore",
        ...words,
        "--dimension",
        String(scene.variation.length),
        "--coefficients",
        scene.variation.join(","),
        "--exact",
      )
    : design("edit", ...words);
  const title = `Figure ${scene.figure}: ${scene.label}`;
  const { format, version, ...rest } = run.design;
  return {
    scene: { ...scene, options },
    figures: run.figures,
    design: { format, version, title, ...rest },
  };
}

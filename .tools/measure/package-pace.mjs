// SPDX-License-Identifier: MIT
// What an edit costs through the npm package, beside the same edit by the page's session: both in this
// process, one after the other, edit by edit, in processor time, so that other programs on the machine
// count little. Prints medians and the median ratio of a pair.
//   bash .tools/start/build.sh wasm npm && node .tools/measure/package-pace.mjs [sample [size [edits [reach]]]]
import { readFile } from "node:fs/promises";
import { edit, Mesh } from "../../build/npm/node.js";

const [sample = "vault", size = "32", edits = "40", rings] = process.argv.slice(2);
const BUILT = new URL("../../build/wasm/wasm/", import.meta.url);

/** Of this process, milliseconds. */
function processorTime() {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

const median = (list) => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];

async function load(name) {
  const { default: create } = await import(new URL(`${name}.mjs`, BUILT).href);
  return create({ wasmBinary: await readFile(new URL(`${name}.wasm`, BUILT)) });
}

function insist(refusal) {
  if (refusal !== "") throw new Error(refusal);
}

const module = await load("planish");
const { options } = (await load("planish_documents")).defaults();
const session = new module.Session();
insist(session.openSample(sample, Number(size)));
const usual = Object.fromEntries(options.map(({ key, usual }) => [key, usual]));
const limit = rings === undefined ? {} : { reach: Number(rings) };
insist(session.setOptions({ ...usual, ...limit }));
const base = session.basePositions();
const mesh = await Mesh.sample(sample, Number(size));

/** Milliseconds, and what moved. */
function bySession(vertex, lift) {
  const begun = processorTime();
  const target = [base[3 * vertex], base[3 * vertex + 1], base[3 * vertex + 2] + lift];
  const handles = Float64Array.of(vertex, ...target);
  insist(session.edit(module.EditMode.solve, handles, new Int32Array(), 0, 0));
  const result = [session.moved(), session.movedPositions(), session.shapeReport()];
  return [processorTime() - begun, result[0].length];
}

function byPackage(vertex, lift) {
  const begun = processorTime();
  const made = edit(mesh, { handles: [{ vertex, by: [0, 0, lift] }], ...limit });
  const result = [made.moved, made.positions, made.report];
  return [processorTime() - begun, result[0].length];
}

const COUNT = base.length / 3;
/** Scattered over the mesh, the same ones every time. */
const scattered = (k) => Math.floor(((((k + 7) * 2654435761) % 2 ** 32) / 2 ** 32) * COUNT);

const pairs = [];
for (let k = -4; k < Number(edits); ++k) {
  const [vertex, lift] = [scattered(k), 0.2 + 0.02 * (k + 4)];
  const [first, second] = k % 2 ? [bySession, byPackage] : [byPackage, bySession];
  const [one, other] = [first(vertex, lift), second(vertex, lift)];
  const [page, own] = k % 2 ? [one, other] : [other, one];
  if (page[1] !== own[1])
    throw new Error(`vertex ${vertex}: ${page[1]} and ${own[1]} points moved`);
  if (k >= 0) pairs.push([page[0], own[0]]); // the first ones warm up
}
const [page, own] = [0, 1].map((k) => median(pairs.map((pair) => pair[k])));
const ratio = median(pairs.map(([a, b]) => b / a));
const difference = median(pairs.map(([a, b]) => b - a));
console.log(
  `${sample}:${size}, ${pairs.length} edits: session ${page.toFixed(1)} ms, package ${own.toFixed(1)} ms; ` +
    `median of pairs: ${((ratio - 1) * 100).toFixed(1)} % or ${difference.toFixed(2)} ms more`,
);

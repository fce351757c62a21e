// SPDX-License-Identifier: MIT
// Everything that docs/paper.md states as measured, from one run.
import { readdirSync, readFileSync } from "node:fs";
import { cpus } from "node:os";
import { join } from "node:path";
import { ROOT, recordedClaims, report } from "./command.mjs";
import { compare } from "./recipes.mjs";

const PUBLIC = { vault: ["sample:vault:32"], dome: ["sample:dome:32"] };
const LIFT = ["--handle", "528+=0,0,1.5"];
export const METHODS = ["newton", "reference", "alm", "admm", "hof10", "hk12", "shapeup", "yypm11"];

const onPublic = (name, method, ...words) =>
  report("compare", method, ...PUBLIC[name], ...LIFT, ...words);

/** Objective and moved vertices of the committed benchmark run, if this machine made one. */
function benchmark(machine) {
  const folder = join(ROOT, "docs/benchmarks");
  for (const name of readdirSync(folder).filter((file) => file.endsWith(".json"))) {
    const run = JSON.parse(readFileSync(join(folder, name), "utf8"));
    const same = machine.replaceAll(/\((R|TM)\)/g, " ").includes(run.machine);
    if (same) return { name, results: run.results };
  }
  return null;
}

/** The public scenes must give what the benchmarks of the same machine say. */
function agreement(machine, methods) {
  const run = benchmark(machine);
  if (!run) return null;
  const rows = [
    ["vault", run.results.EditColdVault],
    ["dome", run.results.EditColdDome],
  ].map(([name, row]) => {
    const { objective, moved_vertices: moved, processor_seconds } = methods[name].newton;
    return { name, objective, moved, seconds: processor_seconds, benchmark: row };
  });
  const agree = rows.every(
    ({ objective, moved, benchmark: row }) =>
      Math.abs(objective / row.objective - 1) < 0.01 && Math.abs(moved - row.moved) <= 1,
  );
  return { file: run.name, rows, agree };
}

const timed = (name) => ({
  newton: onPublic(name, "newton", "--dimension", "4"),
  reference: onPublic(name, "reference", "--dimension", "4"),
});

export function measure(scenes) {
  const machine = cpus()[0]?.model ?? "unknown";
  const methods = {};
  for (const name of Object.keys(PUBLIC)) {
    methods[name] = Object.fromEntries(METHODS.map((method) => [method, onPublic(name, method)]));
  }
  const ofFigure = (figure) => scenes.filter(({ scene }) => scene.figure === figure);
  const closeness = ofFigure(2).map(({ scene }) => ({
    scene,
    ...compare("newton", scene, scene.options),
  }));
  return {
    machine,
    date: new Date().toISOString().slice(0, 10),
    claims: recordedClaims("PaperClaim.*"),
    methods,
    closeness,
    times: Object.fromEntries(Object.keys(PUBLIC).map((name) => [name, timed(name)])),
    stages: onPublic("dome", "alm", "--records"),
    stagesOfOne: onPublic("dome", "admm", "--records"),
    agreement: agreement(machine, methods),
  };
}

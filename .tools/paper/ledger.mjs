// SPDX-License-Identifier: MIT
// Whether every numbered equation of the paper has code and a test, from docs/math.md.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { ROOT } from "./command.mjs";

/** What the paper numbers or sets apart, and the ledger's keys that implement it. */
const EQUATIONS = [
  ["(1), (3)", "the handle edit", ["HE-1", "HE-2", "HE-3", "PB-1"]],
  ["(2)", "fairness", ["EN-1", "EN-2", "EN-3"]],
  ["(4)", "quality of a variation", ["SUB-1"]],
  ["(5), (6), Proposition 1", "correlation", ["SUB-3"]],
  ["(7)", "the subspace", ["SUB-2", "SUB-3", "SUB-4", "SUB-5"]],
  ["(8)", "projection", ["PRO-1", "PRO-2", "PRO-3"]],
  ["(9), (10), (15), (16)", "planarity as a splitting", ["PL-1", "ALM-3"]],
  ["(11), (12), steps 1 to 3", "the converted problem", ["ALM-1"]],
  ["(13), (14), (17)", "the primal update", ["ALM-3"]],
  ["Sec. 3.3", "penalty update, convergence", ["ALM-4", "ALM-5"]],
  ["Sec. 2.1, d", "degrees of freedom", ["MET-2"]],
  ["Fig. 6", "diagonal distance", ["MET-1"]],
  ["Appendix A", "proof of Proposition 1", ["SUB-3"]],
  ["Appendix B", "numerical solution of (7)", ["SUB-6", "SUB-3"]],
];

function ledger() {
  const rows = new Map();
  for (const line of readFileSync(join(ROOT, "docs/math.md"), "utf8").split("\n")) {
    const cells = line.split(/(?<!\\)\|/).map((cell) => cell.trim());
    if (!/^[A-Z]{2,3}-\d+$/.test(cells[1] ?? "")) continue;
    const names = (cell) => [...cell.matchAll(/`([^`]+)`/g)].map(([, name]) => name);
    rows.set(cells[1], { code: names(cells.at(-3)), tests: names(cells.at(-2)) });
  }
  return rows;
}

/** One row per equation; throws where one has no code or no test. */
export function coverage() {
  const rows = ledger();
  return EQUATIONS.map(([equation, what, keys]) => {
    const entries = keys.map((key) => {
      const entry = rows.get(key);
      if (!entry) throw new Error(`docs/math.md has no row ${key}, which ${equation} needs`);
      return entry;
    });
    const code = new Set(entries.flatMap((entry) => entry.code));
    const tests = new Set(entries.flatMap((entry) => entry.tests));
    if (code.size === 0 || tests.size === 0) throw new Error(`${equation} is not covered`);
    return { equation, what, keys, code: code.size, tests: tests.size };
  });
}

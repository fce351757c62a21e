// SPDX-License-Identifier: MIT
import { readFile } from "node:fs/promises";
import { expect, it } from "vitest";
import { DEFAULT_SETTINGS, FIRST_SETTINGS, settingsForNew } from "../../web/src/design/design.ts";

const isUsual = (key: string, value: unknown): boolean =>
  Object.entries(DEFAULT_SETTINGS).some(([name, usual]) => name === key && usual === value);

it("docs/command-line.md says all that the page begins with and the command line does not", async () => {
  const names = {
    softness: "--softness",
    reach: "--reach",
    keepBoundary: "--keep-boundary",
    attraction: "--attraction",
  };
  const other = Object.fromEntries(
    Object.entries(FIRST_SETTINGS).filter(([key, value]) => !isUsual(key, value)),
  );
  expect(Object.keys(other).sort()).toEqual(Object.keys(names).sort());
  const words = Object.entries(names).map(([key, option]) =>
    other[key] === true ? option : `${option} ${other[key]}`,
  );
  const page = new URL("../../docs/command-line.md", import.meta.url);
  expect(await readFile(page, "utf8")).toContain(`the page begins with \`${words.join(" ")}\``);
});

it("another mesh starts with what the page has controls for, and with nothing unseen", () => {
  const shown = {
    attraction: 7,
    locality: 3,
    smoothness: 4,
    fairness: "third",
    engine: "alm",
    sparsity: "l2",
    hardHandles: true,
    keepShape: false,
    tolerance: 0.001,
    keepBends: false,
    maxIterations: 5,
    reach: 3,
    reachLength: 1.5,
    keepBoundary: true,
    supports: ["outline:boundary"],
    continuation: 16,
    limits: ["fold=25"],
    constraints: ["conical:1e-9"],
    keepOuts: ["below=0"],
    clearance: 0.1,
    symmetry: ["x", "axis:z:4"],
    cuts: ["strip=1-2"],
    softness: 4,
  } as const;
  const { sparsity, maxIterations, reachLength, continuation } = DEFAULT_SETTINGS;
  const { attraction, keepOuts, clearance, symmetry, cuts } = FIRST_SETTINGS;
  const steps = { sparsity, maxIterations, reachLength, continuation };
  const unseen = { attraction, keepOuts, clearance, symmetry, cuts, ...steps };
  expect(settingsForNew(shown)).toEqual({ ...shown, ...unseen });
  const bent = { ...shown, tolerance: 67, keepBends: true };
  const { tolerance } = DEFAULT_SETTINGS;
  expect(settingsForNew(bent)).toEqual({ ...shown, ...unseen, tolerance });
  const raw = { ...shown, softness: 0 };
  expect(settingsForNew(raw).attraction).toBe(DEFAULT_SETTINGS.attraction);
  expect(settingsForNew(DEFAULT_SETTINGS)).toEqual(DEFAULT_SETTINGS);
  expect(settingsForNew(FIRST_SETTINGS)).toEqual(FIRST_SETTINGS);
});

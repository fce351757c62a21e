// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import { FAIR_FLAT } from "../../web/src/design/planarising.ts";
import { previewWords } from "../../web/src/features/planarising/preview-words.tsx";
import type { MeshReport, OpenedMesh } from "../../web/src/solver/protocol.ts";
import type { Page } from "../../web/src/state/page.ts";
import { openedPage } from "./support/page-here.ts";

const asFlatAs = (mesh: OpenedMesh, worstExcess: number): OpenedMesh => {
  const report: MeshReport = { ...mesh.report, worstExcess };
  return { ...mesh, report };
};

const words = (page: Page): string =>
  page.mesh.value ? previewWords(page, page.mesh.value.report) : "";

it("a preview is called one: what it shows is not the design", async () => {
  const page = await openedPage("vault");
  const opened = page.mesh.value;
  if (!opened) throw new Error("no mesh");
  page.mesh.value = asFlatAs(opened, 10);
  expect(words(page)).toBe("");
  const trial = {
    how: FAIR_FLAT,
    instead: false,
    mesh: asFlatAs(opened, 0),
    measures: null,
    split: null,
  };
  page.planariseTrial.value = { kind: "shown", trial, sameAs: null };
  expect(words(page)).toMatch(/^A preview of planarising: 400 panels would all be flat, with 0 /);
  expect(words(page)).toContain("The file, which the tables are of, is not flat.");
  const bent = { ...trial, mesh: asFlatAs(opened, DEFAULT_SETTINGS.tolerance + 1) };
  page.planariseTrial.value = { kind: "shown", trial: bent, sameAs: null };
  expect(words(page)).toContain("400 panels would not all be flat");
  const running = {
    kind: "running",
    done: Promise.resolve(null),
    giveUp: () => {},
    step: 0,
  } as const;
  page.planariseTrial.value = { ...running, near: null };
  expect(words(page)).toContain("not all of them flat, and 441 points; planarising is being");
  page.planariseTrial.value = { ...running, near: trial };
  expect(words(page)).toMatch(/^A preview of planarising: 400 panels would all be flat/);
});

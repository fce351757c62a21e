// SPDX-License-Identifier: MIT
// What a Rhino model leaves out is said when it is saved.
import { afterAll, beforeAll, expect, it, vi } from "vitest";
import { exportRhino } from "../../web/src/export/exporting.ts";
import { openedPage } from "./support/page-here.ts";

beforeAll(() => {
  vi.stubGlobal("document", { createElement: () => ({ click: () => undefined }) });
});
afterAll(() => vi.unstubAllGlobals());

/** What the page says once the core has written a model with these gaps. */
async function noticeOf(surfaces: boolean, withoutSurface: readonly string[]) {
  const page = await openedPage("roof", (request) =>
    request.kind === "model"
      ? {
          kind: "modelled",
          job: request.job,
          model: { bytes: new Uint8Array(1), surfaces, withoutSurface },
        }
      : null,
  );
  await exportRhino(page);
  return page.notice.value;
}

it("names the first five panels that have no surface, and that there are others", async () => {
  const left = "not flat enough, or crossing itself. Outlines are all there.";
  expect(await noticeOf(true, ["P3"])).toBe(`No surface in Rhino for P3: ${left}`);
  expect(await noticeOf(true, ["P1", "P2", "P3", "P4", "P5", "P6"])).toBe(
    `No surface in Rhino for P1, P2, P3, P4, P5 and others: ${left}`,
  );
});

it("says that a large model has outlines alone, and nothing where nothing is left out", async () => {
  expect(await noticeOf(false, [])).toContain("outlines and a mesh");
  expect(await noticeOf(true, [])).toBe(null);
});

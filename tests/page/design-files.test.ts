// SPDX-License-Identifier: MIT
// Designs as text, opened over an edit: the design, or one sentence and nothing has changed.
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { flatRoof } from "../browser/support/faults.ts";
import {
  idle,
  movedCount,
  obj,
  openAdvanced,
  openFile,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

const scene = (name: string): string =>
  readFileSync(new URL(`../../docs/scenes/${name}.json`, import.meta.url), "utf8");

const ROOF = flatRoof(6);

const given = (source: object, more: object = {}): string =>
  JSON.stringify({ format: "planish-design", version: 1, source, ...more });

const WHOLE = { file: "roof.obj", format: "obj", bytes: btoa(ROOF) };

it("opens recipes of the paper as the same designs, as one step", async () => {
  const page = await site.open();
  const before = await obj(page);
  for (const name of ["figure-2-region", "figure-4-t3", "figure-9-b"]) {
    const text = scene(name);
    await openFile(page, `${name}.json`, text);
    await page.getByText(/^(Verified:|Replayed: recomputed here)/).waitFor({ timeout: 60_000 });
    expect(await movedCount(page), name).toBe(JSON.parse(text).result.moved);
    await page.getByRole("button", { name: "Undo" }).click();
    await idle(page);
    expect(await obj(page)).toBe(before);
  }
  await page.context().close();
});

it("opens a design whose mesh rides along, and what it does not name has its default", async () => {
  const page = await site.openVault();
  await openFile(page, "roof.json", given(WHOLE, { handles: [[14, 2, 2, 0.4]] }));
  await page.getByText(/^Opened: the design holds no result/).waitFor();
  expect(await movedCount(page)).toBeGreaterThan(0);
  await openAdvanced(page);
  expect(await page.getByRole("slider", { name: "Locality" }).inputValue()).toBe("1");
  const table = page.getByRole("table", { name: "Handles" });
  expect(await table.getByRole("spinbutton").count()).toBe(3);
  await page.getByRole("button", { name: "Remove" }).click();
  await idle(page);
  expect(await movedCount(page)).toBe(0);
  await page.context().close();
});

describe("says in one sentence what is wrong, and nothing has changed", () => {
  const cases: readonly (readonly [string, string, RegExp])[] = [
    ["cut.json", scene("figure-1").slice(0, 200), /not JSON/],
    ["other.json", '{"name":"package"}', /format is missing: it must be planish-design/],
    ["field.json", given({ sample: "vault", size: 9 }, { handles: [[1]] }), /handles\[0\]/],
    ["beside.json", given({ file: "roof.obj" }), /roof\.obj, lies beside it/],
    ["changed.json", given({ ...WHOLE, hash: "00000000" }), /not the one that was edited/],
    ["castle.json", given({ sample: "castle", size: 9 }), /no sample "castle"/],
    [
      "far.json",
      given(WHOLE, { handles: [[900, 0, 0, 0]] }),
      /Handle 900: the mesh has vertices 0 to 48/,
    ],
    ["mesh.json", given({ ...WHOLE, bytes: btoa("v 0 0\n") }), /line 1/],
  ];

  it.each(cases)("%s", async (name, text, sentence) => {
    const page = await site.openVault();
    await typeTarget(page, "+40cm");
    const before = await obj(page);
    await openFile(page, name, text);
    const alert = page.getByRole("alert");
    await expect.poll(() => alert.textContent()).toMatch(/^[a-z]+\.json: [^\n]{10,300}\.$/);
    expect(await alert.textContent()).toMatch(sentence);
    expect(await obj(page)).toBe(before);
    await page.context().close();
  });
});

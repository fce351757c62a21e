// SPDX-License-Identifier: MIT
// GLB out of the page and back into it: judged by the Khronos validator and by another reader.
import { type Document, NodeIO } from "@gltf-transform/core";
import { KHRMaterialsVariants, type MappingList } from "@gltf-transform/extensions";
import { validateBytes } from "gltf-validator";
import type { Page } from "playwright-core";
import { describe, expect, it } from "vitest";
import { type ObjMesh, readObj } from "../browser/support/obj.ts";
import {
  exportAs,
  idle,
  movedCount,
  openFile,
  showTab,
  typeTarget,
} from "../browser/support/page.ts";
import { site } from "./support/site.ts";

async function expectValid(glb: Buffer): Promise<void> {
  const { issues } = await validateBytes(new Uint8Array(glb));
  expect(issues.messages).toEqual([]);
  const { numErrors, numWarnings, numInfos, numHints } = issues;
  expect([numErrors, numWarnings, numInfos, numHints]).toEqual([0, 0, 0, 0]);
}

const readGlb = (glb: Buffer): Promise<Document> =>
  new NodeIO().registerExtensions([KHRMaterialsVariants]).readBinary(new Uint8Array(glb));

interface Panels {
  readonly polygonSizes: number[];
  readonly targetNames?: string[];
}

/** The panels as another program finds them: polygons and points, turned back to z up. */
async function panelsOf(glb: Buffer) {
  const document = await readGlb(glb);
  const node = document
    .getRoot()
    .listNodes()
    .find((n) => n.getName() === "design");
  const mesh = node?.getMesh();
  const primitive = mesh?.listPrimitives()[0];
  const [ox = 0, oy = 0, oz = 0] = node?.getTranslation() ?? [];
  const array = primitive?.getAttribute("POSITION")?.getArray() ?? [];
  const points: number[][] = [];
  for (let k = 0; k + 2 < array.length; k += 3) {
    const [x = 0, y = 0, z = 0] = [array[k], array[k + 1], array[k + 2]];
    points.push([x + ox, -(z + oz), y + oy]);
  }
  const extras = mesh?.getExtras() as unknown as Panels;
  const targets = primitive?.listTargets() ?? [];
  return { points, extras, targets };
}

/** The same points to float32, and the same panel sizes. */
async function expectSameMesh(glb: Buffer, obj: ObjMesh): Promise<void> {
  const { points, extras } = await panelsOf(glb);
  expect(extras.polygonSizes).toEqual(obj.faces.map((face) => face.length));
  expect(points.length).toBe(obj.points.length);
  const size = Math.max(...obj.points.flat().map(Math.abs));
  const off = points.flatMap((p, v) =>
    p.map((x, axis) => x - (obj.points[v]?.[axis] ?? Number.NaN)),
  );
  expect(Math.max(...off.map(Math.abs)) / size).toBeLessThan(1e-6);
}

const exportObj = async (page: Page): Promise<ObjMesh> =>
  readObj((await exportAs(page, "OBJ")).toString());

async function chooseSample(page: Page, name: string): Promise<void> {
  await page.getByRole("combobox", { name: "Sample" }).selectOption(name);
  await idle(page);
}

async function findVariations(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Find variations" }).click();
  await idle(page);
}

async function slide(page: Page, name: string, value: string): Promise<void> {
  const slider = page.getByRole("slider", { name, exact: true });
  await slider.fill(value);
  await slider.dispatchEvent("change");
  await idle(page);
}

describe("a GLB from the page", () => {
  it("is valid and holds the panels: no edit, an edit, variations", async () => {
    const page = await site.openVault();
    for (const sample of ["Hexagonal shell", "Dome"]) {
      await chooseSample(page, sample);
      const plain = await exportAs(page, "GLB");
      await expectValid(plain);
      await expectSameMesh(plain, await exportObj(page));
      await typeTarget(page, "+20cm");
      const edited = await exportAs(page, "GLB");
      await expectValid(edited);
      await expectSameMesh(edited, await exportObj(page));
    }
    await findVariations(page);
    await slide(page, "Variation 1", "0.5");
    const varied = await exportAs(page, "GLB");
    await expectValid(varied);
    await expectSameMesh(varied, await exportObj(page));
    const { targets, extras } = await panelsOf(varied);
    const sliders = await page.getByRole("slider", { name: /^Variation \d+$/ }).count();
    expect(targets.length).toBe(sliders);
    expect(extras.targetNames).toEqual(targets.map((_, k) => `variation ${k + 1}`));
    const json = JSON.parse(varied.subarray(20, 20 + varied.readUInt32LE(12)).toString());
    expect(json.extensionsUsed).toEqual(["KHR_materials_variants"]);
    await page.context().close();
  });

  it("opens again as the editable design", async () => {
    const page = await site.openVault();
    await chooseSample(page, "Dome");
    await typeTarget(page, "+20cm");
    await findVariations(page);
    await slide(page, "Variation 2", "-0.4");
    const [glb, obj, moved] = [
      await exportAs(page, "GLB"),
      await exportObj(page),
      await movedCount(page),
    ];
    const fresh = await site.open(); // no link, whose own "Verified" would answer at once
    await openFile(fresh, "design.glb", glb);
    await expect.poll(() => fresh.getByText(/^Verified/).count()).toBe(1);
    expect(await exportObj(fresh)).toEqual(obj);
    expect(await movedCount(fresh)).toBe(moved);
    expect(
      await fresh.getByRole("table", { name: "Handles" }).getByRole("spinbutton").count(),
    ).toBe(3);
    await showTab(fresh, "Explore");
    expect(await fresh.getByRole("slider", { name: "Variation 2", exact: true }).inputValue()).toBe(
      "-0.4",
    );
    await slide(fresh, "Variation 2", "0");
    expect(await movedCount(fresh)).toBeGreaterThan(0);
    await page.context().close();
    await fresh.context().close();
  });

  it("of a file opens again, edited, with the base's own bits", async () => {
    const page = await site.openVault();
    await chooseSample(page, "Freeform roof");
    const base = (await exportAs(page, "OBJ")).toString();
    await openFile(page, "roof.obj", base);
    await page.getByRole("button", { name: "Start editing" }).click();
    await typeTarget(page, "+20cm");
    const [glb, obj] = [await exportAs(page, "GLB"), await exportObj(page)];
    await openFile(page, "roof.glb", glb);
    await expect.poll(() => page.getByText(/^Verified/).count()).toBe(1);
    expect(await exportObj(page)).toEqual(obj);
    await page.getByRole("button", { name: "Remove" }).click();
    await idle(page);
    expect((await exportAs(page, "OBJ")).toString()).toBe(base);
    await page.context().close();
  });

  it("whose recipe cannot be read opens with the shape that was stored", async () => {
    const page = await site.openVault();
    await chooseSample(page, "Dome");
    await typeTarget(page, "+20cm");
    const [glb, obj] = [await exportAs(page, "GLB"), await exportObj(page)];
    // The same length, so that the container stays whole: a version of the future.
    const newer = Buffer.from(
      glb.toString("latin1").replace('\\"version\\":1', '\\"version\\":7'),
      "latin1",
    );
    await openFile(page, "newer.glb", newer);
    await expect.poll(() => page.getByText(/version 7/).count()).toBe(1);
    expect(await exportObj(page)).toEqual(obj);
    await page.context().close();
  });
});

it("a GLB from the page can be shown as glass or as a heat map: each variant has its material", async () => {
  const page = await site.openVault();
  await chooseSample(page, "Dome");
  await typeTarget(page, "+20cm");
  const document = await readGlb(await exportAs(page, "GLB"));
  const primitive = document
    .getRoot()
    .listMeshes()
    .find((mesh) => mesh.getName() === "design")
    ?.listPrimitives()[0];
  const list = primitive?.getExtension<MappingList>("KHR_materials_variants");
  const mapped = (list?.listMappings() ?? []).flatMap((mapping) =>
    mapping.listVariants().map((variant) => [variant.getName(), mapping.getMaterial()] as const),
  );
  expect(mapped.map(([name]) => name).toSorted()).toEqual(["glass", "heat map"]);
  const [glass, heat] = ["glass", "heat map"].map(
    (name) => mapped.find(([variant]) => variant === name)?.[1],
  );
  expect([glass?.getName(), heat?.getName()]).toEqual(["glass", "heat map"]);
  // What makes them look so: glass lets light through, the heat map shows the points' colours.
  expect(glass?.getAlphaMode()).toBe("BLEND");
  expect(glass?.getBaseColorFactor()[3]).toBeLessThan(1);
  expect(heat?.getAlphaMode()).toBe("OPAQUE");
  expect(heat?.getBaseColorFactor()).toEqual([1, 1, 1, 1]);
  expect(primitive?.getAttribute("COLOR_0")?.getCount()).toBeGreaterThan(0);
  // A reader that knows no variants shows the heat map.
  expect(primitive?.getMaterial()).toBe(heat);
  await page.context().close();
});

it("OBJ and PLY out of the page hold the same bits", async () => {
  const page = await site.openVault();
  await chooseSample(page, "Hexagonal shell");
  await typeTarget(page, "+10cm");
  const obj = (await exportAs(page, "OBJ")).toString();
  const ply = await exportAs(page, "PLY");
  await openFile(page, "again.ply", ply);
  await page.getByRole("button", { name: /Start editing|Not now/ }).click();
  expect((await exportAs(page, "OBJ")).toString()).toBe(obj);
  await openFile(page, "again.obj", obj);
  await page.getByRole("button", { name: /Start editing|Not now/ }).click();
  expect((await exportAs(page, "OBJ")).toString()).toBe(obj);
  await page.context().close();
});

// SPDX-License-Identifier: MIT
// The page and the command line write the same files for the workshop, byte for byte.
import { execFileSync, spawnSync } from "node:child_process";
import { createHash } from "node:crypto";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Session } from "@wasm/planish.mjs";
import type { CuttingHeader, ShopDesign, ShopOrder } from "@wasm/planish_documents.mjs";
import { afterAll, beforeAll, expect, it } from "vitest";
import { linkCode } from "../../web/src/export/link-code.ts";
import { plainOptions } from "../../web/src/solver/cutting-options.ts";
import { loadDocuments, loadPlanish } from "./support/planish.ts";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;
const SAMPLES = ["vault", "dome", "freeform", "hex", "trihex"];

let folder: string;
beforeAll(() => {
  folder = mkdtempSync(join(tmpdir(), "planish-shop-"));
});
afterAll(() => rmSync(folder, { recursive: true }));

const digestOf = (name: string): string =>
  createHash("sha256")
    .update(readFileSync(join(folder, name)))
    .digest("hex");
const command = (words: string) => execFileSync(CLI, words.split(" "), { cwd: folder });

const designOf = (session: Session): ShopDesign => ({
  base: session.basePositions(),
  offsets: session.faceOffsets(),
  vertices: session.faceVertices(),
  moved: session.moved(),
  movedPositions: session.movedPositions(),
  parents: session.panelParents(),
});

const OPTIONS = { ...plainOptions("m", "mm"), name: "design" };

/** Edits a sample; base.obj and design.obj are in the folder then. */
async function editedSample(sample: string): Promise<ShopDesign> {
  const planish = await loadPlanish();
  const session = new planish.Session();
  expect(session.openSample(sample, 12)).toBe("");
  writeFileSync(join(folder, "base.obj"), session.write("obj"));
  const middle = Math.floor(session.basePositions().length / 6);
  const [x = 0, y = 0, z = 0] = session.basePositions().subarray(3 * middle);
  const handle = Float64Array.of(middle, x, y, z + 0.3);
  expect(session.edit(planish.EditMode.solve, handle, new Int32Array(), 0, 1)).toBe("");
  writeFileSync(join(folder, "design.obj"), session.write("obj"));
  const design = designOf(session);
  session.delete();
  return design;
}

async function made(design: ShopDesign, order: ShopOrder) {
  const digest = createHash("sha256");
  const shop = await loadDocuments();
  const { problem, header } = shop.write(design, order, (piece) => digest.update(piece));
  expect(problem).toBe("");
  expect("missed" in header).toBe(order.what === "drawings");
  return { hash: digest.digest("hex"), header: header as CuttingHeader };
}

it.each(SAMPLES)("of an edited %s", async (sample) => {
  const design = await editedSample(sample);
  const link = `https://planish.example/#v1=${"Az09_-".repeat(40)}`;
  const sizes = { gap: 6, thickness: 8, sheetWidth: 6000, sheetHeight: 3000, textHeight: 20 };
  const order: ShopOrder = {
    what: "package",
    options: { ...OPTIONS, ...sizes, remakeOnly: true },
    code: linkCode(link),
  };
  const written = await made(design, order);
  const { remake, counts, labels } = written.header;
  expect(remake?.outline).toBeGreaterThan(0);
  expect(counts.drawn).toBe((remake?.outline ?? 0) + (remake?.bevel ?? 0));
  expect(labels).toEqual({ count: counts.drawn, link, code: true });
  const against = "--against base.obj";
  command(
    `panels design.obj -o p.zip ${against} --gap 6 --thickness 8 --sheet 6000x3000 --scope remake --text-height 20 --link ${link}`,
  );
  expect(written.hash).toBe(digestOf("p.zip"));

  command(`panels design.obj -o flat.ifc ${against}`);
  expect((await made(design, { what: "ifc", options: OPTIONS })).hash).toBe(digestOf("flat.ifc"));
  command(`panels design.obj -o solid.ifc ${against} --unit ft --gap 0.02 --thickness 0.1`);
  const solid = { ...OPTIONS, unit: "ft", gap: 0.02, thickness: 0.1 };
  expect((await made(design, { what: "ifc", options: solid })).hash).toBe(digestOf("solid.ifc"));

  const middle = 3 * Math.floor(design.base.length / 6);
  const [x, y] = [0, 1].map((axis) => Number((design.base[middle + axis] ?? 0).toFixed(3)) + 0.01);
  const where = `--section x=${x} --section y=${y}`;
  const axes = ["x=1:A", "x=2.5:B", "z=0.25:Träger&Sohn"];
  const grid = axes.map((axis) => `--axis ${axis}`).join(" ");
  command(`drawings design.obj -o d.zip ${where} ${grid} --unit cm --scale 50`);
  const drawings = {
    name: "design",
    modelUnit: "m",
    unit: "cm",
    scale: 50,
    axes,
  };
  const sections = [1, 0, 0, x ?? 0, 0, -1, 0, -(y ?? 0)];
  expect((await made(design, { what: "drawings", options: { ...drawings, sections } })).hash).toBe(
    digestOf("d.zip"),
  );
});

/** Sums over many corners must not depend on where the numbers lie in memory. */
it.each(["hex", "trihex"])("of a %s whose panels are not quite flat", async (sample) => {
  const { base, offsets, vertices } = await editedSample(sample);
  const rough = base.map((x, k) => x + 1e-4 * Math.sin(k * k));
  const lines: string[] = [];
  for (let k = 0; k < rough.length; k += 3) lines.push(`v ${rough.subarray(k, k + 3).join(" ")}`);
  for (let f = 0; f + 1 < offsets.length; ++f) {
    const corners = vertices.subarray(offsets[f], offsets[f + 1]);
    lines.push(`f ${corners.map((v) => v + 1).join(" ")}`);
  }
  writeFileSync(join(folder, "rough.obj"), `${lines.join("\n")}\n`);
  const [moved, movedPositions] = [new Int32Array(), new Float64Array()];
  const parents = new Int32Array();
  const design = { base: rough, offsets, vertices, moved, movedPositions, parents };
  const options = { ...OPTIONS, name: "rough" };
  const written = await made(design, { what: "package", options, code: linkCode("") });
  const words = ["panels", "rough.obj", "-o", "p.zip", "--against", "rough.obj"];
  expect(spawnSync(CLI, words, { cwd: folder }).status).toBe(4);
  expect(written.hash).toBe(digestOf("p.zip"));
});

it.each([1, 28, 500, 1370, 1371])("with a link of %i characters on the labels", async (length) => {
  const design = await editedSample("vault");
  const link = "https://planish.example/#v1=".padEnd(length, "aB3-_").slice(0, length);
  const options = { ...OPTIONS, panels: [3, 5] };
  const written = await made(design, { what: "package", options, code: linkCode(link) });
  const words = `panels design.obj -o p.zip --against base.obj --scope 3,5 --link ${link}`;
  const { status } = spawnSync(CLI, words.split(" "), { cwd: folder });
  expect(status).toBe(length > 1370 ? 4 : 0);
  expect(written.header.labels?.code).toBe(length <= 1370);
  expect(written.hash).toBe(digestOf("p.zip"));
});

it.each([
  { gap: 6, sheetWidth: 6000, sheetHeight: 3000, remakeOnly: false },
  { gap: 300, sheetWidth: 1500, sheetHeight: 900, remakeOnly: true },
  { gap: 0, sheetWidth: 0, sheetHeight: 0, remakeOnly: true },
])("the preview says what the package will: %o", async (asked) => {
  const [design, shop] = [await editedSample("freeform"), await loadDocuments()];
  const options = { ...OPTIONS, ...asked };
  const preview = shop.cuttingPreview(design, options, -1, true);
  const order: ShopOrder = { what: "package", options, code: linkCode("") };
  const { counts, remake, sheets, ...header } = (await made(design, order)).header;
  expect([preview.panels, preview.drawn]).toEqual([counts.panels, counts.drawn]);
  expect([preview.outline, preview.bevel]).toEqual([remake?.outline, remake?.bevel]);
  expect([preview.nodesMoved, preview.nodesArms]).toEqual([
    remake?.nodes_moved,
    remake?.nodes_arms,
  ]);
  expect([preview.flatness, preview.vanished]).toEqual([header.flatness_mm_per_m, header.vanished]);
  expect(preview.excess).toBe(header.excess_mm_per_m);
  expect([preview.sheets, preview.usedFraction, preview.oversize]).toEqual(
    sheets ? [sheets.count, sheets.used_fraction, sheets.oversize] : [0, 0, []],
  );
  expect(preview.map).toMatch(/^<svg/);
  expect(preview.drawing).toContain(preview.shown);
});

it("refuses by name what is wrong, as a sentence", async () => {
  const design = await editedSample("vault");
  const options = { ...OPTIONS, sheetWidth: 100 };
  const shop = await loadDocuments();
  const code = linkCode("");
  let pieces = 0;
  const refusal = (order: ShopOrder) => shop.write(design, order, () => ++pieces).problem;
  expect(refusal({ what: "package", options, code })).toMatch(
    /^The cutting package was refused: sheet .+\.$/,
  );
  const inYards = { ...OPTIONS, unit: "yard" };
  expect(refusal({ what: "ifc", options: inYards })).toMatch(/^The model was refused: unit .+\.$/);
  const drawings = { name: "", modelUnit: "m", unit: "mm", scale: -1, sections: [], axes: [] };
  expect(refusal({ what: "drawings", options: drawings })).toMatch(
    /^The drawings were refused: scale .+\.$/,
  );
  const noAxis = { ...drawings, scale: 0, axes: ["q=1"] };
  expect(refusal({ what: "drawings", options: noAxis })).toBe(
    'The drawings were refused: axis "q=1" is not x=V, y=V or z=V, or one with :NAME behind it.',
  );
  expect(pieces).toBe(0);
});

// SPDX-License-Identifier: MIT
// What a newcomer's first drag gives: the pulsing point dragged 10 to 150 pixels in eight directions, on a
// desk and on a phone; the exported file is measured by code of its own. Prints the figures of
// docs/decisions/0009-reach-and-softness.md: `node .tools/measure/first-drag.mjs` after `npm run build`.
import { readFile } from "node:fs/promises";
import { hintedPoint, openBrowser, openPage } from "../page/page.mjs";

const SCREENS = [
  { width: 1440, height: 900 },
  { width: 390, height: 844 },
];
const PIXELS = [10, 25, 50, 100, 150];
const DIRECTIONS = 8;

const minus = (a, b) => a.map((x, k) => x - b[k]);
const cross = (a, b) =>
  [0, 1, 2].map((k) => {
    const [i, j] = [(k + 1) % 3, (k + 2) % 3];
    return a[i] * b[j] - a[j] * b[i];
  });
const dot = (a, b) => a.reduce((sum, x, k) => sum + x * b[k], 0);

function readObj(text) {
  const lines = text.split("\n").map((line) => line.split(" "));
  const points = lines.filter(([kind]) => kind === "v").map(([, ...x]) => x.map(Number));
  const faces = lines
    .filter(([kind]) => kind === "f")
    .map(([, ...words]) => words.map((word) => Number.parseInt(word, 10) - 1));
  return { points, faces };
}

const normalOf = (face, points) => {
  const arms = face.slice(1).map((v) => minus(points[v], points[face[0]]));
  const areas = arms.slice(1).map((arm, k) => cross(arms[k], arm));
  return areas.reduce((sum, area) => sum.map((x, k) => x + area[k]));
};

/** Degrees, by edge. */
function folds({ faces }, points) {
  const [normals, sides] = [faces.map((face) => normalOf(face, points)), new Map()];
  faces.forEach((face, f) => {
    face.forEach((v, k) => {
      const w = face[(k + 1) % face.length];
      const key = [Math.min(v, w), Math.max(v, w)].join();
      sides.set(key, [...(sides.get(key) ?? []), f]);
    });
  });
  const found = new Map();
  for (const [key, [f, g]] of sides) {
    if (g === undefined) continue;
    const across = cross(normals[f], normals[g]);
    const angle = Math.atan2(Math.hypot(...across), dot(normals[f], normals[g]));
    found.set(key, (angle * 180) / Math.PI);
  }
  return found;
}

/** Convex panels whose corners no longer all turn the way that their old normal says. */
function spoilt({ faces, points }, after) {
  const turns = (face, at, normal) =>
    face.map((v, k) => {
      const [before, next] = [face.at(k - 1), face[(k + 1) % face.length]];
      return dot(cross(minus(at[v], at[before]), minus(at[next], at[v])), normal);
    });
  return faces.filter((face) => {
    const old = normalOf(face, points);
    const now = normalOf(face, after);
    if (Math.min(...turns(face, points, old)) <= 0) return false;
    return dot(old, now) <= 0 || Math.min(...turns(face, after, now)) <= 0;
  }).length;
}

async function exported(page) {
  await page.getByRole("button", { name: "Export" }).click();
  const download = page.waitForEvent("download");
  await page.getByRole("button", { name: "OBJ", exact: true }).click();
  return readObj((await readFile(await (await download).path())).toString());
}

const idle = async (page) => {
  await page.waitForTimeout(120);
  await page.getByRole("button", { name: "Cancel" }).and(page.locator(":disabled")).waitFor();
};

async function drag(page, at, by) {
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  for (let k = 1; k <= 5; ++k) await page.mouse.move(at.x + (by.x * k) / 5, at.y + (by.y * k) / 5);
  await page.mouse.up();
  await idle(page);
}

async function measure(site, viewport) {
  const page = await openPage(site, { viewport, reducedMotion: "reduce" });
  const at = await hintedPoint(page);
  const base = await exported(page);
  const before = folds(base, base.points);
  const runs = [];
  for (const pixels of PIXELS) {
    for (let k = 0; k < DIRECTIONS; ++k) {
      const angle = (2 * Math.PI * k) / DIRECTIONS;
      await drag(page, at, { x: pixels * Math.sin(angle), y: -pixels * Math.cos(angle) });
      const { points } = await exported(page);
      const after = folds(base, points);
      const kink = Math.max(...[...after].map(([edge, fold]) => fold - before.get(edge)));
      const words = await page.getByRole("status").textContent();
      const far = Math.max(...points.map((p, v) => Math.hypot(...minus(p, base.points[v]))));
      runs.push({ pixels, kink, spoilt: spoilt(base, points), far });
      if (process.env.VERBOSE) console.log(pixels, k * 45, kink.toFixed(1), far.toFixed(2), words);
      await page.getByRole("button", { name: "Undo" }).click();
      await idle(page);
    }
  }
  await page.context().close();
  return runs;
}

const site = await openBrowser();
console.log("| screen | pixels | spoilt | kink, median | kink, worst | largest move, m |");
console.log("| --- | --- | --- | --- | --- | --- |");
for (const screen of SCREENS) {
  const runs = await measure(site, screen);
  for (const pixels of PIXELS) {
    const some = runs.filter((run) => run.pixels === pixels);
    const kinks = some.map(({ kink }) => kink).sort((a, b) => a - b);
    const bad = some.filter((run) => run.spoilt > 0).length;
    const cells = [`${screen.width} × ${screen.height}`, pixels, `${bad} of ${some.length}`];
    const far = Math.max(...some.map((run) => run.far));
    cells.push(
      `${kinks[kinks.length / 2].toFixed(1)}°`,
      `${kinks.at(-1).toFixed(1)}°`,
      far.toFixed(2),
    );
    console.log(`| ${cells.join(" | ")} |`);
  }
}
await site.close();

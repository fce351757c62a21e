// SPDX-License-Identifier: MIT
// Recipes and links into docs/scenes.
import { mkdirSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { cameraOf } from "./camera.mjs";
import { ROOT } from "./command.mjs";
import { linksOf } from "./links.mjs";
import { record } from "./recipes.mjs";
import { OFFERED, SCENES } from "./scenes.mjs";

const FOLDER = join(ROOT, "docs/scenes");

const save = (name, value) =>
  writeFileSync(join(FOLDER, name), `${JSON.stringify(value, null, 2)}\n`);

/** Records every scene anew. Each comes with its link and the report of its run. */
export async function writeScenes() {
  const recorded = SCENES.map(record);
  const links = await linksOf(
    recorded.map(({ scene, design }) => ({ design, camera: cameraOf(scene) })),
  );
  const scenes = recorded.map((entry, k) => ({ ...entry, ...links[k] }));
  mkdirSync(FOLDER, { recursive: true });
  for (const name of readdirSync(FOLDER)) rmSync(join(FOLDER, name));
  for (const { scene, design } of scenes) {
    writeFileSync(join(FOLDER, `${scene.name}.json`), `${JSON.stringify(design)}\n`);
  }
  save(
    "links.json",
    scenes.map(({ scene: { name, figure, label }, moved, link }) => ({
      name,
      figure,
      label,
      moved,
      link,
    })),
  );
  save(
    "offered.json",
    scenes
      .filter(({ scene }) => OFFERED.has(scene.name))
      .map(({ scene: { name, figure }, link }) => ({
        name,
        label: `Figure ${figure}: ${OFFERED.get(name)}`,
        link,
      })),
  );
  return scenes;
}

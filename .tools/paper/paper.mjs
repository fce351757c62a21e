// SPDX-License-Identifier: MIT
// Rebuilds docs/paper.md, docs/scenes and the pictures of the figures from nothing:
//
//     bash .tools/start/build.sh && cmake --build --preset native --target planish_tests
//     node .tools/paper/paper.mjs            everything
//     node .tools/paper/paper.mjs scenes     recipes and links only, in seconds
import { writeScenes } from "./writing.mjs";

const scenes = await writeScenes();
console.log(`docs/scenes: ${scenes.length} recipes and links`);
if (!process.argv.includes("scenes")) {
  const { writePaper } = await import("./whole.mjs");
  if (!(await writePaper(scenes))) process.exitCode = 1;
}
process.exit();

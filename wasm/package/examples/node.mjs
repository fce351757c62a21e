// Raises one point of a mesh and writes the result: node node.mjs roof.obj 136 0.7 edited.glb
import { readFile, writeFile } from "node:fs/promises";
import { basename } from "node:path";
import { edit, Mesh } from "planish";

const [file, vertex = "136", height = "0.7", output = "edited.glb"] = process.argv.slice(2);
const mesh = file
  ? await Mesh.read(await readFile(file), basename(file))
  : await Mesh.sample("vault", 16);
const result = edit(mesh, {
  handles: [{ vertex: Number(vertex), by: [0, 0, Number(height)] }],
  reach: 5,
  softness: 5,
});
for (const message of result.messages) console.error(message);
await writeFile(output, result.write("glb"));
console.log(`${result.report.status}: ${result.moved.length} points move; ${output}`);

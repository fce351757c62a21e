// SPDX-License-Identifier: MIT
// What docs/fabrication.md says of 10,000 panels on sheets: processor time, memory and size of the
// package, on the command line and by the page's module in node.
//   bash .tools/start/build.sh native wasm && node .tools/measure/shop-module.mjs [panels along a side]
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import createDocuments from "../../build/wasm/wasm/planish_documents.mjs";
import { quadRoof } from "./shop-roof.mjs";

const SIDE = Number(process.argv[2] ?? 100);
const BUILT = new URL("../../build/", import.meta.url).pathname;
const folder = mkdtempSync(join(tmpdir(), "planish-shop-module-"));
const { points, faces, obj } = quadRoof(SIDE);

writeFileSync(join(folder, "roof.obj"), obj);
const words = ["panels", "roof.obj", "-o", "p.zip", "--sheet", "6000x3000", "--report", "r.json"];
const script =
  "import resource,subprocess,sys\nr=subprocess.run(sys.argv[1:]).returncode\n" +
  "u=resource.getrusage(resource.RUSAGE_CHILDREN)\nprint(r,u.ru_utime+u.ru_stime,u.ru_maxrss/1024)";
const timed = spawnSync("python3", ["-c", script, join(BUILT, "native/planish"), ...words], {
  cwd: folder,
  encoding: "utf8",
});
const [code, seconds, peak] = timed.stdout.trim().split(" ").map(Number);
const { sheets } = JSON.parse(readFileSync(join(folder, "r.json"), "utf8"));
const size = statSync(join(folder, "p.zip")).size;
console.log(
  `command line: exit ${code}, ${faces.length} panels on ${sheets.count} sheets, ${seconds.toFixed(1)} s of processor time, at most ${peak.toFixed(0)} MB of memory, ${(size / 1e6).toFixed(1)} MB`,
);
rmSync(folder, { recursive: true });

let memory = null;
const shop = await createDocuments({
  instantiateWasm(imports, done) {
    const wasm = readFileSync(join(BUILT, "wasm/wasm/planish_documents.wasm"));
    WebAssembly.instantiate(wasm, imports).then(({ instance, module }) => {
      memory = Object.values(instance.exports).find((e) => e instanceof WebAssembly.Memory);
      done(instance, module);
    });
    return {};
  },
});
const options = {
  name: "roof",
  modelUnit: "m",
  unit: "mm",
  gap: 0,
  thickness: 0,
  sheetWidth: 6000,
  sheetHeight: 3000,
  textHeight: 0,
  remakeOnly: false,
  panels: [],
};
const base = Float64Array.from(points.flat());
const design = {
  base,
  offsets: Int32Array.from({ length: faces.length + 1 }, (_, f) => 4 * f),
  vertices: Int32Array.from(faces.flat()),
  moved: new Int32Array(),
  movedPositions: new Float64Array(),
};
const begun = process.cpuUsage();
let [bytes, pieces, longest] = [0, 0, 0];
const order = { what: "package", options, code: { link: "", size: 0, dark: [] } };
const { problem } = shop.write(design, order, (piece) => {
  bytes += piece.length;
  pieces += 1;
  longest = Math.max(longest, piece.length);
});
const { user, system } = process.cpuUsage(begun);
console.log(
  `module: ${problem || "written"}, ${((user + system) / 1e6).toFixed(1)} s of processor time, ${(memory.buffer.byteLength / 1e6).toFixed(0)} MB of memory, ${(bytes / 1e6).toFixed(1)} MB in ${pieces} pieces of at most ${(longest / 1e6).toFixed(1)} MB`,
);

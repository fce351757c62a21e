// SPDX-License-Identifier: MIT
// Measures what docs/reliability.md says of large and of nasty files: a mesh of 1,000,000 points read
// by the command line and by the built page, and the refusal of every file of a folder, natively and
// in WebAssembly. Wall-clock time, so on a machine that does nothing else.
//   bash .tools/start/build.sh && node .tools/measure/limits.mjs [FOLDER of nasty files]
import { execFileSync, spawnSync } from "node:child_process";
import {
  createWriteStream,
  existsSync,
  mkdtempSync,
  readdirSync,
  readFileSync,
  rmSync,
} from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { launch } from "../page/browser.mjs";
import { serve } from "../page/serve.mjs";

const CLI = "build/native/planish";
const SIDE = 1000;

/** A wavy roof of SIDE × SIDE points, panels flat or nearly so. */
async function writeLargeMesh(path) {
  const out = createWriteStream(path);
  for (let i = 0; i < SIDE; ++i) {
    const rows = Array.from({ length: SIDE }, (_, j) => {
      const z = 3 * Math.sin(j / 120) + 2 * Math.cos(i / 90);
      return `v ${(j / 2).toFixed(6)} ${(i / 2).toFixed(6)} ${z.toFixed(9)}`;
    });
    out.write(`${rows.join("\n")}\n`);
  }
  for (let i = 0; i + 1 < SIDE; ++i) {
    const rows = Array.from({ length: SIDE - 1 }, (_, j) => {
      const a = i * SIDE + j + 1;
      return `f ${a} ${a + 1} ${a + SIDE + 1} ${a + SIDE}`;
    });
    out.write(`${rows.join("\n")}\n`);
  }
  await new Promise((done) => out.end(done));
}

const seconds = (milliseconds) => `${(milliseconds / 1000).toFixed(2)} s`;

function elapsed(act) {
  const start = performance.now();
  act();
  return performance.now() - start;
}

/** From the choice of the file to the import report, and the longest stop of the page meanwhile. */
async function importInPage(path) {
  const { server, url } = await serve("dist", { prefix: "/under/a/path/" });
  const browser = await launch({ smooth: true });
  const page = await browser.newPage({ viewport: { width: 900, height: 640 } });
  await page.goto(url);
  await page.getByText(/0 of 441 points move/).waitFor();
  await page.waitForTimeout(2000);
  await page.evaluate(() => {
    window.tasks = [];
    new PerformanceObserver((list) => {
      for (const { duration, startTime } of list.getEntries())
        window.tasks.push({ duration, startTime });
    }).observe({ type: "longtask" });
  });
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  const chosen = await chooser;
  const start = await page.evaluate(() => performance.now());
  const before = processorTimes();
  await chosen.setFiles(path);
  await page.getByRole("heading", { name: "large.obj" }).waitFor({ timeout: 120_000 });
  const shown = await page.evaluate(() => performance.now());
  await page.waitForTimeout(3000);
  const tasks = await page.evaluate(() => window.tasks);
  const after = processorTimes();
  await browser.close();
  server.close();
  return {
    time: shown - start,
    spent: busiest(before, after),
    tasks: tasks.map((t) => ({ at: t.startTime - start, duration: t.duration })),
  };
}

/** Processor time so far of each page's own thread and of its solver, seconds, by process (Linux). */
function processorTimes() {
  const times = new Map();
  for (const pid of readdirSync("/proc").filter((name) => /^\d+$/.test(name))) {
    try {
      if (!readFileSync(`/proc/${pid}/cmdline`, "utf8").includes("--type=renderer")) continue;
      const total = { page: 0, solver: 0 };
      for (const tid of readdirSync(`/proc/${pid}/task`)) {
        const task = `/proc/${pid}/task/${tid}`;
        const spent = Number(readFileSync(`${task}/schedstat`, "utf8").split(" ")[0]) / 1e9;
        if (tid === pid) total.page += spent;
        else if (readFileSync(`${task}/comm`, "utf8").startsWith("Dedicated"))
          total.solver += spent;
      }
      times.set(pid, total);
    } catch {
      // It ended meanwhile.
    }
  }
  return times;
}

/** What the busiest solver and its page took in between. */
function busiest(before, after) {
  let most = { page: 0, solver: 0 };
  for (const [pid, { page, solver }] of after) {
    const from = before.get(pid) ?? { page: 0, solver: 0 };
    const spent = { page: page - from.page, solver: solver - from.solver };
    if (spent.solver > most.solver) most = spent;
  }
  return most;
}

async function loadModule() {
  const { default: create } = await import(pathToFileURL("build/wasm/wasm/planish.mjs").href);
  return create({ wasmBinary: readFileSync("build/wasm/wasm/planish.wasm") });
}

/** Each file read by both builds: name, whether it is refused, and how long that takes. */
async function nastyFiles(folder) {
  const module = await loadModule();
  return readdirSync(folder)
    .sort()
    .map((name) => {
      const path = join(folder, name);
      let refused = false;
      const native = elapsed(() => {
        refused = spawnSync(CLI, ["info", path]).status !== 0;
      });
      const bytes = readFileSync(path);
      const session = new module.Session();
      let sentence = "";
      const wasm = elapsed(() => {
        sentence = session.openFile(bytes, name.split(".").at(-1));
      });
      session.delete();
      if (refused !== (sentence !== "")) throw new Error(`${name}: the builds do not agree`);
      return { name, refused, native, wasm, sentence };
    });
}

const folder = mkdtempSync(join(tmpdir(), "planish-limits-"));
const large = join(folder, "large.obj");
await writeLargeMesh(large);
const native = elapsed(() => execFileSync(CLI, ["info", large]));
console.log(`1,000,000 points, command line: ${seconds(native)} (with all its figures)`);
const { time, spent, tasks } = await importInPage(large);
const longest = Math.max(0, ...tasks.map(({ duration }) => duration));
console.log(
  `1,000,000 points, page: ${seconds(time)}, longest task of the page ${Math.round(longest)} ms`,
);
console.log(
  `  processor time: solver ${spent.solver.toFixed(2)} s, page ${spent.page.toFixed(2)} s`,
);
for (const { at, duration } of tasks)
  console.log(`  task at ${seconds(at)}: ${Math.round(duration)} ms`);
rmSync(folder, { recursive: true });

const nasty = process.argv[2] ?? "../shared/meshes/nasty";
if (existsSync(nasty)) {
  const files = await nastyFiles(nasty);
  for (const { name, refused, native, wasm, sentence } of files)
    console.log(
      `${name.padEnd(36)} ${refused ? "refused" : "opened "} native ${native.toFixed(0)} ms, wasm ${wasm.toFixed(1)} ms  ${sentence}`,
    );
  const slowest = (key) => Math.max(...files.map((file) => file[key])).toFixed(0);
  console.log(
    `${files.length} files, ${files.filter((f) => f.refused).length} refused; slowest: native ${slowest("native")} ms (with the start of the process), wasm ${slowest("wasm")} ms`,
  );
}

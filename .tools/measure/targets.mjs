// SPDX-License-Identifier: MIT
// What the page promises about time, measured on the built site in a real browser (how much it
// loads is a test, tests/browser/transfer.test.ts):
// node .tools/measure/targets.mjs [name…]   (ready drag cancel link)
// Wall-clock figures come with the load of the machine; processor times of the page's own thread
// come from the browser's trace and say what the page does, whatever else runs.
import { loadavg } from "node:os";
import { findVariations, lift, openBrowser, openPage, settled } from "../page/page.mjs";

const VIEW = { width: 1280, height: 800 };
const LOADS = 11;

const median = (values) => values.toSorted((a, b) => a - b)[values.length >> 1];
const ms = (value) => `${value.toFixed(0)} ms`;

/** Notes when the page says that it can be used, and every later change of the status line. */
const watchStatus = () => {
  window.statusTimes = [];
  const look = () => {
    const text = document.querySelector("[role=status]")?.textContent ?? "";
    if (!text.includes("points move")) return;
    window.readyAt ??= performance.now();
    if (text !== window.lastStatus) window.statusTimes.push(performance.now());
    window.lastStatus = text;
  };
  new MutationObserver(look).observe(document, {
    subtree: true,
    childList: true,
    characterData: true,
  });
};

async function readyTimes(site, options) {
  const context = await site.browser.newContext({ viewport: VIEW, ...options });
  await context.addInitScript(watchStatus);
  const page = await context.newPage();
  const times = [];
  for (let k = 0; k < LOADS; ++k) {
    await page.goto("about:blank");
    await page.goto(site.url);
    await page.getByRole("status").filter({ hasText: "points move" }).waitFor();
    times.push(await page.evaluate("window.readyAt"));
    await page.waitForTimeout(300);
  }
  await context.close();
  return times.slice(1);
}

async function ready(site) {
  for (const serviceWorkers of ["block", "allow"]) {
    const times = await readyTimes(site, { serviceWorkers });
    const how = serviceWorkers === "block" ? "from the browser's cache" : "by the service worker";
    const [low, high] = [Math.min(...times), Math.max(...times)];
    console.log(`ready ${how}: ${ms(median(times))} (${ms(low)} to ${ms(high)}); at most 1500 ms`);
  }
}

/** A translational surface of 71 × 71 points: every panel is a parallelogram, so flat. */
function largeMesh(count = 71) {
  const lines = [];
  const x = (i) => [0.5 * i, 1.2 * Math.sin(0.08 * i)];
  for (let j = 0; j < count; ++j)
    for (let i = 0; i < count; ++i) lines.push(`v ${x(i)[0]} ${x(j)[0]} ${x(i)[1] + x(j)[1]}`);
  for (let j = 0; j + 1 < count; ++j)
    for (let i = 0; i + 1 < count; ++i) {
      const a = count * j + i + 1;
      lines.push(`f ${a} ${a + 1} ${a + count + 1} ${a + count}`);
    }
  return lines.join("\n");
}

async function openLarge(site, viewport) {
  const context = await site.browser.newContext({ viewport, reducedMotion: "reduce" });
  await context.addInitScript(watchStatus);
  const page = await context.newPage();
  await page.goto(site.url);
  await page.getByRole("status").filter({ hasText: "points move" }).waitFor();
  const chooser = page.waitForEvent("filechooser");
  await page.getByRole("button", { name: "Open file" }).click();
  const buffer = Buffer.from(largeMesh());
  await (await chooser).setFiles({ name: "large.obj", mimeType: "text/plain", buffer });
  await page.getByRole("button", { name: "Start editing" }).click();
  await settled(page);
  return page;
}

/** Tasks of each thread in a trace: wall and processor time, ms. */
function tasksOf(events) {
  const names = new Map();
  for (const { name, pid, tid, args } of events)
    if (name === "thread_name") names.set(`${pid} ${tid}`, args.name);
  const tasks = { CrRendererMain: [], "DedicatedWorker thread": [] };
  for (const { name, pid, tid, dur, tdur } of events) {
    if (name !== "ThreadControllerImpl::RunTask" && name !== "RunTask") continue;
    if (dur === undefined) continue; // still running when the trace ended
    tasks[names.get(`${pid} ${tid}`)]?.push({ wall: dur / 1000, cpu: (tdur ?? 0) / 1000 });
  }
  return tasks;
}

async function traced(page, act) {
  const session = await page.context().newCDPSession(page);
  const events = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  const done = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await session.send("Tracing.start", {
    traceConfig: { includedCategories: ["toplevel", "devtools.timeline", "__metadata"] },
    transferMode: "ReportEvents",
  });
  await act();
  await session.send("Tracing.end");
  await done;
  return tasksOf(events);
}

/** Moves of the held pointer every 10 ms, whatever the screen does; gives seconds. */
const movePointer = async ([x, y, duration]) => {
  const canvas = document.querySelector("canvas");
  window.statusTimes.length = 0;
  const begin = performance.now();
  for (let k = 1; performance.now() < begin + duration; ++k) {
    const place = { clientX: x, clientY: y - 20 * Math.sin(k / 16) };
    const held = { pointerId: 1, pointerType: "mouse", isPrimary: true, buttons: 1 };
    canvas.dispatchEvent(new PointerEvent("pointermove", { ...held, ...place }));
    await new Promise((next) => setTimeout(next, 10));
  }
  return (performance.now() - begin) / 1000;
};

/** Drags the middle of the view up and down for a while. */
async function dragFor(page, duration) {
  const box = await page.getByLabel("3D view").boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x, y - 6);
  const seconds = await page.evaluate(movePointer, [x, y, duration]);
  const updates = await page.evaluate("window.statusTimes.length");
  await page.mouse.up();
  return { seconds, updates };
}

/** In a small view: drawing without a graphics card is no concern of the page. */
async function drag(site) {
  const page = await openLarge(site, { width: 640, height: 480 });
  // The first press fetches the arrows; the drag that counts is the next one.
  await dragFor(page, 500);
  await settled(page);
  let run = { seconds: 0, updates: 0 };
  const tasks = await traced(page, async () => {
    run = await dragFor(page, 6000);
  });
  await settled(page);
  const said = await page.getByRole("status").first().textContent();
  const { CrRendererMain: main, "DedicatedWorker thread": worker } = tasks;
  const longest = (kind) => Math.max(...main.map((task) => task[kind]));
  const each = (list) =>
    (list.reduce((sum, { cpu }) => sum + cpu, 0) / Math.max(1, run.updates)).toFixed(1);
  console.log(`drag at 5041 points, ${run.seconds.toFixed(1)} s (${said}):`);
  console.log(
    `  longest task: ${ms(longest("cpu"))} of processor, ${ms(longest("wall"))} on the clock; at most 50 ms`,
  );
  console.log(`  status updates: ${(run.updates / run.seconds).toFixed(1)} a second; at least 20`);
  console.log(`  per update: page ${each(main)} ms, solver ${each(worker)} ms of processor`);
  await page.context().close();
}

/** Milliseconds from Cancel to the last design shown again, and to a solver that waits again. */
const timeCancel = async () => {
  const find = (name) =>
    [...document.querySelectorAll("button")].find((b) => b.textContent === name);
  const frame = () => new Promise(requestAnimationFrame);
  const before = document.querySelector("[role=status]").textContent;
  find("Find variations").click();
  while (find("Cancel").disabled) await frame();
  await new Promise((next) => setTimeout(next, 20));
  const begin = performance.now();
  find("Cancel").click();
  const points = (text) => text.split(" points")[0];
  do await frame();
  while (points(document.querySelector("[role=status]").textContent) !== points(before));
  const shown = performance.now() - begin;
  while (!find("Cancel").disabled) await frame();
  return { shown, ready: performance.now() - begin };
};

async function cancel(site) {
  const page = await openLarge(site, VIEW);
  await lift(page, "+2m");
  const times = [];
  for (let k = 0; k < 5; ++k) {
    times.push(await page.evaluate(timeCancel));
    await settled(page);
  }
  const shown = times.map((time) => time.shown);
  const again = times.map((time) => time.ready);
  console.log(
    `cancel: the last design after ${ms(median(shown))}, at worst ${ms(Math.max(...shown))}; at most 200 ms`,
  );
  console.log(`  the next edit can begin after ${ms(median(again))}`);
  await page.context().close();
}

async function link(site) {
  const page = await openPage(site, { viewport: VIEW });
  await lift(page, "+1200mm");
  const read = async () => {
    await page.getByRole("button", { name: "Share" }).click();
    const value = await page.getByRole("textbox", { name: "Link" }).inputValue();
    await page.keyboard.press("Escape");
    return value.length;
  };
  console.log(`link, one edit of a sample: ${await read()} characters; at most 600`);
  await findVariations(page);
  await page.getByRole("slider", { name: "Variation 1" }).fill("0.5");
  await settled(page);
  console.log(`link, the same with a variation: ${await read()} characters`);
  await page.context().close();
}

const TARGETS = { ready, drag, cancel, link };

const only = process.argv.slice(2);
const site = await openBrowser();
console.log(
  `load of the machine: ${loadavg()
    .map((x) => x.toFixed(1))
    .join(", ")}`,
);
for (const [name, measure] of Object.entries(TARGETS)) {
  if (only.length === 0 || only.includes(name)) await measure(site);
}
console.log(`load afterwards: ${loadavg()[0].toFixed(1)}`);
await site.close();

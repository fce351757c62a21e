// SPDX-License-Identifier: MIT
// What a first visit waits for on a line of 10 Mbit/s and 40 ms with an empty cache: until the page is ready and
// until the first drag has moved points, in ms since the address was opened; the median of some visits and the
// slowest, and the same without the line: what the machine itself takes. Files go packed, as every static server
// can send them. `node .tools/measure/first-visit.mjs` after `npm run build`.
import { createServer as createHttpServer } from "node:http";
import { connect, createServer } from "node:net";
import { gzipSync } from "node:zlib";
import { launch } from "../page/browser.mjs";
import { hintedPoint } from "../page/page.mjs";
import { serve } from "../page/serve.mjs";

const [BITS_PER_MS, ROUND_TRIP, VISITS] = [10_000, 40, 5];
const later = (wait) => new Promise((done) => setTimeout(done, wait));
const listening = (server) =>
  new Promise((done) => server.listen(0, () => done(server.address().port)));

/** The site's files, packed once. */
async function packed(directory) {
  const { server: plain, url } = await serve(directory);
  const kept = new Map();
  const server = createHttpServer(async (request, response) => {
    if (!kept.has(request.url)) {
      const answer = await fetch(new URL(request.url, url));
      const body = gzipSync(Buffer.from(await answer.arrayBuffer()), { level: 9 });
      kept.set(request.url, {
        status: answer.status,
        type: answer.headers.get("content-type"),
        body,
      });
    }
    const { status, type, body } = kept.get(request.url);
    response.writeHead(status, { "content-type": type, "content-encoding": "gzip" }).end(body);
  });
  return {
    port: await listening(server),
    close: () => [plain, server].map((each) => each.close()),
  };
}

/** All connections to `port` share the line: a piece leaves after those before it and arrives half a round trip later. */
async function line(port) {
  let free = 0;
  const carry = (from, to, bitsPerMs) => {
    from.on("error", () => to.destroy());
    from.on("data", (piece) => {
      free = Math.max(free, performance.now()) + (piece.length * 8) / bitsPerMs;
      setTimeout(() => to.write(piece), free - performance.now() + ROUND_TRIP / 2);
    });
    from.on("end", () => setTimeout(() => to.end(), free - performance.now() + ROUND_TRIP / 2));
  };
  const server = createServer(async (visitor) => {
    visitor.pause();
    await later(ROUND_TRIP); // The handshake.
    const site = connect(port);
    carry(visitor, site, Number.POSITIVE_INFINITY);
    carry(site, visitor, BITS_PER_MS);
    visitor.resume();
  });
  return { port: await listening(server), close: () => server.close() };
}

async function visit(browser, url) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 900 } });
  const page = await context.newPage();
  const opened = performance.now();
  const since = () => performance.now() - opened;
  await page.goto(url, { waitUntil: "commit" });
  await page.getByRole("status").filter({ hasText: "points move" }).waitFor({ timeout: 60_000 });
  const ready = since();
  const { x, y } = await hintedPoint(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let step = 1; step <= 5; step += 1) await page.mouse.move(x, y - 6 * step);
  await page
    .getByRole("status")
    .filter({ hasText: /[1-9]\d* of \d+ points move/ })
    .waitFor();
  const dragged = since();
  await page.mouse.up();
  await context.close();
  return { ready, dragged };
}

const site = await packed(new URL("../../dist/", import.meta.url).pathname);
const slow = await line(site.port);
const browser = await launch();
for (const [where, port] of [
  ["on the line", slow.port],
  ["without it", site.port],
]) {
  const visits = [];
  for (let round = 0; round <= VISITS; round += 1) {
    const times = await visit(browser, `http://localhost:${port}/`);
    if (round > 0) visits.push(times); // The first one packs the files.
  }
  for (const what of ["ready", "dragged"]) {
    const sorted = visits.map((each) => each[what]).sort((a, b) => a - b);
    const [median, slowest] = [sorted[VISITS >> 1], sorted.at(-1)].map((ms) => ms.toFixed(0));
    console.log(`${what} ${where}: ${median} ms, slowest ${slowest} ms`);
  }
}
await browser.close();
for (const each of [slow, site]) each.close();

// SPDX-License-Identifier: MIT
// Keeps one complete version of the page for use without a network. A new version waits until
// the page says so, so that one visit never mixes two.
const VERSION = "__VERSION__";
const FILES = ["__FILES__"];
/** Parts that are kept once somebody has asked for them. */
const LATER = ["__LATER__"];
const NAME = `planish-${VERSION}`;

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(NAME).then((cache) => cache.addAll(FILES)));
});

/** The version before this one stays: a tab that still runs it may start another worker. */
async function dropOldVersions() {
  const names = await caches.keys();
  const old = names.filter((name) => name.startsWith("planish-") && name !== NAME);
  await Promise.all(old.slice(0, -1).map((name) => caches.delete(name)));
  await self.clients.claim();
}

self.addEventListener("activate", (event) => event.waitUntil(dropOldVersions()));

const isGuide = (url) => url.startsWith(new URL("./guide/", self.registration.scope).href);

async function answer(request) {
  const cache = await caches.open(NAME);
  const isPage = request.mode === "navigate" && !isGuide(request.url);
  const wanted = isPage ? "./index.html" : request;
  const own = await cache.match(wanted, { ignoreSearch: true });
  const kept = own ?? (await caches.match(request, { ignoreSearch: true }));
  if (kept) return kept;
  const fetched = await fetch(request);
  const [url] = request.url.split("#");
  const isPart = LATER.some((name) => new URL(name, self.registration.scope).href === url);
  // A full disk is no reason to do without.
  if (fetched.ok && isPart) await cache.put(request, fetched.clone()).catch(() => {});
  return fetched;
}

self.addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  if (method === "GET" && url.startsWith(self.registration.scope)) {
    event.respondWith(answer(event.request));
  }
});

self.addEventListener("message", (event) => {
  if (event.data === "take over") self.skipWaiting();
});

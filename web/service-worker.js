// SPDX-License-Identifier: MIT
// Keeps one complete version of the page for use without a network. A new version waits until
// the page says so, so that one visit never mixes two.
const VERSION = "__VERSION__";
const FILES = ["__FILES__"];
const NAME = `planish-${VERSION}`;

self.addEventListener("install", (event) => {
  event.waitUntil(caches.open(NAME).then((cache) => cache.addAll(FILES)));
});

async function dropOldVersions() {
  const names = await caches.keys();
  await Promise.all(
    names
      .filter((name) => name.startsWith("planish-") && name !== NAME)
      .map((name) => caches.delete(name)),
  );
  await self.clients.claim();
}

self.addEventListener("activate", (event) => event.waitUntil(dropOldVersions()));

async function answer(request) {
  const cache = await caches.open(NAME);
  const wanted = request.mode === "navigate" ? "./index.html" : request;
  return (await cache.match(wanted, { ignoreSearch: true })) ?? fetch(request);
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

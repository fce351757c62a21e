// SPDX-License-Identifier: MIT
// A plain static file server: no special headers, so that what works here works anywhere. With `open`
// its files may be fetched from any origin, as GitHub Pages has it and a sandboxed frame needs it.
import { createReadStream } from "node:fs";
import { stat } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join, normalize, resolve, sep } from "node:path";
import { fileURLToPath } from "node:url";

const TYPES = {
  ".css": "text/css; charset=utf-8",
  ".glb": "model/gltf-binary",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript; charset=utf-8",
  ".json": "application/json",
  ".mjs": "text/javascript; charset=utf-8",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
  ".woff2": "font/woff2",
};

async function locate(root, path) {
  const file = join(root, normalize(decodeURIComponent(path)));
  if (file !== root && !file.startsWith(root + sep)) return null;
  const info = await stat(file).catch(() => null);
  if (!info) return null;
  return info.isDirectory() ? locate(root, `${path.replace(/\/$/, "")}/index.html`) : file;
}

/** Serves `directory` below `prefix`; resolves with the address once it listens. */
export function serve(directory, { port = 0, prefix = "/", open = false } = {}) {
  const root = resolve(directory);
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url ?? "/", "http://localhost");
    const file = pathname.startsWith(prefix)
      ? await locate(root, `/${pathname.slice(prefix.length)}`).catch(() => null)
      : null;
    if (!file) {
      response.writeHead(404, { "content-type": "text/plain" }).end("Not found\n");
      return;
    }
    response.writeHead(200, {
      "content-type": TYPES[extname(file)] ?? "application/octet-stream",
      "cache-control": "no-cache",
      ...(open && { "access-control-allow-origin": "*" }),
    });
    createReadStream(file).pipe(response);
  });
  return new Promise((done, failed) => {
    server.once("error", failed);
    server.listen(port, () => {
      done({ server, url: `http://localhost:${server.address().port}${prefix}` });
    });
  });
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [directory = "dist"] = process.argv.slice(2);
  const port = Number(process.env.PORT ?? 4173);
  serve(directory, { port }).then(
    ({ url }) => console.log(`Planish is at ${url}  (Ctrl-C stops it)`),
    (error) => {
      console.error(
        error.code === "EADDRINUSE" ? `Port ${port} is taken: set PORT.` : error.message,
      );
      process.exitCode = 1;
    },
  );
}

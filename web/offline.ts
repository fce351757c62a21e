// SPDX-License-Identifier: MIT
// Build only: the service worker with its list of files, and the page's content security policy.
import { createHash } from "node:crypto";
import { readdirSync, readFileSync } from "node:fs";
import type { Plugin } from "vite";

const POLICY = [
  "default-src 'none'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' blob: data:",
  "font-src 'self'",
  "connect-src 'self'",
  // In a sandboxed frame a worker is made of text that imports the page's own, see spawn.ts.
  "worker-src 'self' data:",
  "manifest-src 'self'",
  "base-uri 'none'",
  "form-action 'none'",
].join("; ");

const here = (path: string): URL => new URL(path, import.meta.url);

/** What few need, a megabyte after gzip and the guide: comes when it is asked for, and stays from then on. */
const comesLater = (name: string): boolean => /\brhino3dm[.-]|^guide\//.test(name);

const list = (names: readonly string[]): string =>
  names.map((name) => JSON.stringify(`./${name}`)).join(", ");

export function offline(): Plugin {
  return {
    name: "offline",
    apply: "build",
    enforce: "post",
    transformIndexHtml: (_, { bundle = {} }) => [
      // The solver loads beside the page's own script instead of after it.
      ...Object.keys(bundle)
        .filter((name) => /planish-[^/]*\.wasm$/.test(name))
        .map((name) => ({
          tag: "link",
          attrs: { rel: "preload", as: "fetch", href: `./${name}`, crossorigin: "anonymous" },
          injectTo: "head" as const,
        })),
      {
        tag: "meta",
        attrs: { "http-equiv": "Content-Security-Policy", content: POLICY },
        injectTo: "head-prepend",
      },
    ],
    generateBundle(_, bundle) {
      const files = [...Object.keys(bundle), ...readdirSync(here("public"))].sort();
      const digest = createHash("sha256");
      for (const [name, item] of Object.entries(bundle)) {
        digest.update(name).update(item.type === "chunk" ? item.code : item.source);
      }
      const source = readFileSync(here("service-worker.js"), "utf8")
        .replace("__VERSION__", digest.digest("hex").slice(0, 16))
        .replace('"__FILES__"', list(files.filter((name) => !comesLater(name))))
        .replace('"__LATER__"', list(files.filter(comesLater)));
      this.emitFile({ type: "asset", fileName: "service-worker.js", source });
    },
  };
}

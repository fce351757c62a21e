// SPDX-License-Identifier: MIT
// Nothing that a file, a link or a name brings can become markup or code: what the sources say of it. That it
// does not is tested in a browser (tests/browser/security.test.ts).
import { readdirSync, readFileSync } from "node:fs";
import { expect, it } from "vitest";

it("no code makes markup or code of data", () => {
  const sources = readdirSync("web/src", { recursive: true, encoding: "utf8" })
    .filter((path) => /\.tsx?$/.test(path))
    .map((path) => [path, readFileSync(`web/src/${path}`, "utf8")] as const);
  const doors = /innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function\(/;
  expect(sources.filter(([, text]) => doors.test(text)).map(([path]) => path)).toEqual([]);
  const raw = sources.filter(([, text]) => text.includes("dangerouslySetInnerHTML"));
  expect(raw.map(([path]) => path)).toEqual(["ui/icon.tsx"]);
});

it("every package is pinned, and the lock file agrees", () => {
  const read = (path: string) => JSON.parse(readFileSync(path, "utf8"));
  const own = read("package.json");
  const lock = read("package-lock.json");
  const wanted: Record<string, string> = { ...own.dependencies, ...own.devDependencies };
  for (const [name, version] of Object.entries(wanted)) {
    expect(version, name).toMatch(/^\d+\.\d+\.\d+(-[\w.]+)?$/);
    expect(lock.packages[`node_modules/${name}`]?.version, name).toBe(version);
  }
  for (const [path, entry] of Object.entries<{ integrity?: string; link?: boolean }>(lock.packages))
    if (path) expect(entry.integrity, path).toMatch(/^sha512-/);
});

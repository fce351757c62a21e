// SPDX-License-Identifier: MIT
// Packages are pinned: each to one version, and what npm installs for it to a checksum.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

const read = (name: string) => JSON.parse(readFileSync(name, "utf8"));
const { dependencies, devDependencies } = read("package.json");

it.each(Object.entries({ ...dependencies, ...devDependencies }))(
  "%s has one version",
  (_, version) => {
    expect(version).toMatch(/^\d+\.\d+\.\d+(-[a-z]+[\d.]*)?$/);
  },
);

it("every package that is installed has a checksum", () => {
  const { packages } = read("package-lock.json");
  const installed = Object.entries<{ integrity?: string; link?: boolean }>(packages).filter(
    ([path, { link }]) => path !== "" && !link,
  );
  expect(installed.length).toBeGreaterThan(30);
  for (const [path, { integrity }] of installed) {
    expect(integrity, path).toMatch(/^sha512-/);
  }
});

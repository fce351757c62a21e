// SPDX-License-Identifier: MIT
// planish.d.ts is written by hand; this holds it to what the module really has.
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";
import { loadPlanish } from "./support/planish.ts";

const declarations = readFileSync(new URL("../../wasm/planish.d.ts", import.meta.url), "utf8");

/** Names that the body of `interface <name>` declares at its first level. */
function declared(name: string): string[] {
  const body = new RegExp(`interface ${name} \\{([\\s\\S]*?)\\n\\}`).exec(declarations)?.[1] ?? "";
  return [...body.matchAll(/^ {2}(?:readonly )?(\w+)[(:]/gm)].map((match) => match[1] ?? "").sort();
}

const inherited = new Set(["constructor", "isAliasOf", "clone", "isDeleted", "deleteLater"]);

it("declares every bound member of Session and binds every declared one", async () => {
  const { Session } = await loadPlanish();
  const session = new Session();
  const bound = new Set<string>();
  for (let at = session; at !== Object.prototype; at = Object.getPrototypeOf(at)) {
    for (const name of Object.getOwnPropertyNames(at)) {
      if (!inherited.has(name) && name !== "$$") bound.add(name);
    }
  }
  session.delete();
  expect([...bound].sort()).toEqual(declared("Session"));
});

it.each(["EditMode", "Engine", "FairnessKind", "Sparsity"] as const)(
  "declares every value of %s",
  async (name) => {
    const module = await loadPlanish();
    const line = new RegExp(`${name}: \\{(.*)\\};`).exec(declarations)?.[1] ?? "";
    const names = [...line.matchAll(/(\w+): EnumValue/g)].map((match) => match[1]);
    const values = module[name] as Record<string, { value?: number }>;
    const bound = Object.keys(values).filter((key) => typeof values[key]?.value === "number");
    expect(bound.filter((key) => key !== "values").sort()).toEqual(names.sort());
  },
);

it("stays a page long", () => {
  expect(declarations.split("\n").length).toBeLessThanOrEqual(110);
});

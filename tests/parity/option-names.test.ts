// SPDX-License-Identifier: MIT
// The options of the npm package are typed by hand; this holds their names to the commands' --help.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { expect, it } from "vitest";

const CLI = new URL("../../build/native/planish", import.meta.url).pathname;

/** Options of a command that no program asks for, each with its reason. */
const OF_COMMANDS: Readonly<Record<string, string>> = {
  "-o": "write() gives the bytes",
  "--report": "a result has its report",
  "--design": "a result has its design",
  "--threads": "the module has one",
};

/** The same of one command alone. */
const OF_ONE: Readonly<Record<string, Readonly<Record<string, string>>>> = {
  explore: {
    "--coefficients": "Family.at() takes them, many of one family",
    "--exact": "Variation.exact() does it",
  },
  mobility: {
    "--part": "a program chooses its vertices",
    "--estimate": "what the command says of a long run",
    "--best": "rows are sorted by whoever has them",
  },
};

/** Members that are no options. */
const OF_PROGRAMS: Readonly<Record<string, string>> = { progress: "who watches" };

const INTERFACES = [
  ["edit", "edit", "EditOptions"],
  ["explore", "edit", "ExploreOptions"],
  ["project", "operations", "ProjectOptions"],
  ["offset", "operations", "OffsetOptions"],
  ["mobility", "mobility", "MobilityOptions"],
  ["convert", "operations", "ConvertOptions"],
  ["types", "types", "TypesOptions"],
] as const;

/** "--keep-boundary" … of a command, as --help lists them. */
function helpOf(command: string): string[] {
  const help = execFileSync(CLI, [command, "--help"], { encoding: "utf8" });
  return [...help.matchAll(/^ {2}(--?[a-z-]+) /gm)].map((row) => row[1] ?? "");
}

/** The members of an interface, with those that it takes from others, and whether any name goes. */
function membersOf(file: string, name: string): { names: string[]; open: boolean } {
  const url = new URL(`../../wasm/package/src/${file}.ts`, import.meta.url);
  const text = readFileSync(url, "utf8");
  const [, others = "", body = ""] =
    new RegExp(`export interface ${name}\\b([^{]*)\\{([\\s\\S]*?)\\n\\}`).exec(text) ?? [];
  const own = [...body.matchAll(/^ {2}readonly (\w+)\??:/gm)].map((member) => member[1] ?? "");
  const values = others.includes("Partial<EditValues>")
    ? membersOf("edit-values", "EditValues").names
    : [];
  return { names: [...own, ...values], open: /^ {2}readonly \[/m.test(body) };
}

const inTypeScript = (option: string): string =>
  option.replace(/^--/, "").replace(/-([a-z])/g, (_, letter: string) => letter.toUpperCase());

it.each(INTERFACES)(
  "%s: every option is a member of its interface, every member an option",
  (command, file, name) => {
    const edits = command === "explore" ? new Set(helpOf("edit")) : new Set<string>();
    const apart = { ...OF_COMMANDS, ...OF_ONE[command] };
    const { names, open } = membersOf(file, name);
    const expected = helpOf(command)
      .filter((option) => !(option in apart || edits.has(option)))
      .map(inTypeScript)
      .map((option) => (names.includes(`${option}s`) ? `${option}s` : option));
    expect(names.filter((member) => !(member in OF_PROGRAMS)).sort()).toEqual(expected.sort());
    expect(open, "a name that is no option is an error of the compiler").toBe(false);
  },
);

it("every exception is of an option that there is", () => {
  const known = INTERFACES.flatMap(([command]) => helpOf(command));
  for (const option of Object.keys(OF_COMMANDS)) expect(known).toContain(option);
  for (const [command, options] of Object.entries(OF_ONE))
    expect(helpOf(command)).toEqual(expect.arrayContaining(Object.keys(options)));
});

// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { crc32 } from "../../web/src/bytes/crc32.ts";
import { DEFAULT_SETTINGS } from "../../web/src/design/design.ts";
import { decodeLink, encodeLink } from "../../web/src/design/link.ts";
import type { Recipe } from "../../web/src/design/recipe.ts";
import type { Result } from "../../web/src/result/result.ts";

/** tests/parity/bindings.test.ts holds the core to it. */
const MARK = {
  hash: 2756894708,
  moved: 2,
  probes: [3, 0.1, 0.2, 0.3, 7, 0.333333333333, 0.666666666667, 1],
};

const recipe: Recipe = {
  source: { kind: "sample", name: "vault", size: 21 },
  planarised: null,
  handles: [
    { vertex: 220, target: [10.1, 9.9, 1 / 3], pinned: false },
    { vertex: 5, target: [0, 0, 0], pinned: true },
  ],
  settings: { ...DEFAULT_SETTINGS, smoothness: 0.5, keepShape: false },
  families: [{ coefficients: [0.5, -0.25], asked: 2, eigenbasis: false }],
  unit: "m",
  camera: null,
  mark: MARK,
};

const withFile: Recipe = {
  ...recipe,
  planarised: {
    smooth: 0,
    keepBoundary: false,
    keepShape: false,
    constraints: [],
    within: 0,
    flat: 0,
  },
  families: [],
  source: {
    kind: "file",
    name: "röof.obj",
    format: "obj",
    bytes: new Blob([Uint8Array.of(1, 2, 250)]),
    crc: crc32(Uint8Array.of(1, 2, 250)),
  },
  camera: { position: [1.5, -2, 0.125], target: [0, 0, 1] },
};

const FAIR = {
  smooth: 100,
  keepBoundary: true,
  keepShape: true,
  constraints: [],
  within: 0,
  flat: 0,
};
const CIRCULAR = { ...FAIR, constraints: ["circular:1e-9"] };

const inSteps: Recipe = {
  ...recipe,
  families: [
    { coefficients: [1 / 3], asked: 3, eigenbasis: true },
    { coefficients: [0.1, 0, -1], asked: 3, eigenbasis: false },
  ],
};

const WEIGHTS = {
  fairness: 7.5,
  sparsity: 0.3,
  closeness: 4,
  correlation: 0.5,
  spread: 3,
  family: 9,
};

/** Found by other weights than the core's, first, last or between. */
const weighted: Recipe = {
  ...recipe,
  families: inSteps.families.flatMap((family) => [family, { ...family, weights: WEIGHTS }]),
};

/** Version 1 as it was when it was published: it must open for ever. */
const GOLDEN =
  "#v1=XY4xDsIwEATzlq0X6-zgOPFP0MkFgkgUkCCSECRExU94DRVvQqZByky5xezz9d58iqK4Y0BUXLfTcQSdTcQZUYgDoqpzQivGsjENxZQLKInqKT9tSsSMqFZEaCnGE0O767s9iK6dx75DIm6ImreVGOcTMSHiBOKCqC74qm7WQWo6asmcFuNymmFxgGKqPyH3H18";

async function content(decoded: Result<Recipe>): Promise<Uint8Array | null> {
  if (!decoded.ok || decoded.value.source.kind === "sample") return null;
  return new Uint8Array(await decoded.value.source.bytes.arrayBuffer());
}

it("every link of docs/paper.md can be read", async () => {
  const scenes = new URL("../../docs/scenes/links.json", import.meta.url);
  const links = JSON.parse(readFileSync(scenes, "utf8")) as { name: string; link: string }[];
  expect(links.length).toBeGreaterThan(20);
  for (const { name, link } of links) {
    const decoded = await decodeLink(link);
    expect(decoded.ok, name).toBe(true);
  }
});

describe("links", () => {
  it.each([
    ["a sample", recipe],
    ["variations of other weights", weighted],
    ["a file", withFile],
    ["a file made fair", { ...withFile, planarised: FAIR }],
    ["a file made nearly flat", { ...withFile, planarised: { ...FAIR, within: 0.3, flat: 20 } }],
    ["a file made circular", { ...withFile, planarised: CIRCULAR }],
    [
      "an ℓ2 edit",
      { ...recipe, settings: { ...recipe.settings, sparsity: "l2" } } satisfies Recipe,
    ],
    [
      "a reach and a softness",
      {
        ...recipe,
        settings: { ...recipe.settings, reach: 4, keepBoundary: true, softness: 6.5 },
      } satisfies Recipe,
    ],
    [
      "a boundary on its outline",
      {
        ...recipe,
        settings: { ...recipe.settings, keepBoundary: true, supports: ["outline:boundary"] },
      } satisfies Recipe,
    ],
    [
      "a boundary on its level",
      {
        ...recipe,
        settings: { ...recipe.settings, supports: ["level=z:boundary"] },
      } satisfies Recipe,
    ],
    [
      "points on supports of their own",
      {
        ...recipe,
        settings: {
          ...recipe.settings,
          supports: ["level=z:boundary", "level=x:3,4", "line=0,0,1e-7,0,0,-1:7"],
          constraints: ["conical:0.001"],
          limits: ["angle=60:120"],
        },
      } satisfies Recipe,
    ],
    [
      "a continuation",
      {
        ...recipe,
        settings: { ...recipe.settings, keepShape: true, softness: 5, continuation: 16 },
      } satisfies Recipe,
    ],
    [
      "stated limits",
      {
        ...recipe,
        settings: { ...recipe.settings, keepShape: true, limits: ["fold=+5", "edge=0.5:2"] },
      } satisfies Recipe,
    ],
    [
      "kept kinds",
      {
        ...recipe,
        settings: {
          ...recipe.settings,
          limits: ["fold=25"],
          constraints: ["circular:1e-9", "conical:0.001"],
        },
      } satisfies Recipe,
    ],
    ["families one after the other", inSteps],
  ])("give back %s exactly", async (_, original) => {
    const link = await encodeLink(original);
    expect(link).toMatch(/^#v1=[\w-]+$/);
    const decoded = await decodeLink(link);
    expect(decoded).toEqual({ ok: true, value: original });
    expect(await content(decoded)).toEqual(await content({ ok: true, value: original }));
  });

  it("of a sample with one edit stay short", async () => {
    const link = await encodeLink({
      ...recipe,
      handles: recipe.handles.slice(0, 1),
      families: [],
    });
    expect(link.length).toBeLessThan(600);
  });

  it("from version 1 open", async () => {
    expect(await decodeLink(GOLDEN)).toEqual({ ok: true, value: recipe });
  });

  it("say what is wrong, whatever they are", async () => {
    const link = await encodeLink(recipe);
    const broken = [
      "",
      "#",
      "#v1=",
      "#v1=%%%",
      "#v1=AAAA",
      "#v9=abc",
      "#x",
      link.replace("v1", "v2"),
    ];
    for (let cut = 4; cut < link.length; cut += 7) broken.push(link.slice(0, cut));
    for (let at = 4; at < link.length; at += 5) {
      const other = link[at] === "A" ? "B" : "A";
      broken.push(link.slice(0, at) + other + link.slice(at + 1));
    }
    for (const text of broken) {
      const result = await decodeLink(text);
      expect(result, text).toMatchObject({ ok: false, reason: expect.stringMatching(/\.$/) });
    }
  });
});

it("the checksum is the usual CRC-32", () => {
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});

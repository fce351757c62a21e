// SPDX-License-Identifier: MIT
import { readFileSync } from "node:fs";
import { deflateSync, inflateSync } from "node:zlib";
import { linkDictionary } from "virtual:core-defaults";
import { describe, expect, it } from "vitest";
import { crc32 } from "../../web/src/bytes/crc32.ts";
import { DEFAULT_SETTINGS, toTargets } from "../../web/src/design/design.ts";
import { isLink } from "../../web/src/design/fragment.ts";
import { packLink, unpackLink } from "../../web/src/design/link.ts";
import type { Recipe, Steps } from "../../web/src/design/recipe.ts";
import type { Result } from "../../web/src/result/result.ts";
import { GOLDEN_LINKS } from "./support/golden-links.ts";
import { decodeLink, encodeLink } from "./support/links.ts";

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

/** The first link that was published. */
const FIRST =
  "#v1=XY4xDsIwEATzlq0X6-zgOPFP0MkFgkgUkCCSECRExU94DRVvQqZByky5xezz9d58iqK4Y0BUXLfTcQSdTcQZUYgDoqpzQivGsjENxZQLKInqKT9tSsSMqFZEaCnGE0O767s9iK6dx75DIm6ImreVGOcTMSHiBOKCqC74qm7WQWo6asmcFuNymmFxgGKqPyH3H18";

async function content({ source }: Steps): Promise<Uint8Array | null> {
  return source.kind === "sample" ? null : new Uint8Array(await source.bytes.arrayBuffer());
}

const opened = <T>(result: Result<T>): T => {
  if (!result.ok) throw new Error(result.reason);
  return result.value;
};

it.each(["links.json", "offered.json"])(
  "every link of docs/scenes/%s can be read",
  async (file) => {
    const scenes = new URL(`../../docs/scenes/${file}`, import.meta.url);
    const links = JSON.parse(readFileSync(scenes, "utf8")) as { name: string; link: string }[];
    expect(links.length).toBeGreaterThan(5);
    for (const { name, link } of links) {
      const decoded = await decodeLink(link);
      expect(decoded.ok, name).toBe(true);
    }
  },
);

describe("links of version 1", () => {
  it("open: the first that was published", async () => {
    expect(await decodeLink(FIRST)).toEqual({ ok: true, value: recipe });
  });

  it.each(GOLDEN_LINKS)("open: $name", async ({ link, recipe: golden }) => {
    const read = opened(await decodeLink(link));
    expect(read).toEqual(golden);
    expect(await content(read)).toEqual(await content(golden));
  });
});

/** What the core refuses to do again: a family chosen from more needs the eigenbasis. */
const REFUSED = "variations of other weights";

/** The core writes a number in one way. */
const inCoreText = (given: Recipe): Recipe => {
  const { keepOuts, supports } = given.settings;
  const settings = {
    ...given.settings,
    keepOuts: keepOuts.map((text) => text.replace("-1e-3", "-0.001")),
    supports: supports.map((text) => text.replace("1e-7", "1e-07")),
  };
  return { ...given, settings };
};

describe("links", () => {
  it.each(GOLDEN_LINKS.filter(({ name }) => name !== REFUSED))(
    "give back $name exactly, shorter than version 1",
    async ({ link: first, recipe: original }) => {
      const link = await encodeLink(original);
      expect(link).toMatch(/^#v2=[\w-]+$/);
      expect(isLink(link)).toBe(true);
      expect(link.length).toBeLessThan(first.length);
      const { handles, ...read } = opened(await decodeLink(link));
      const { handles: given, companions, ...rest } = inCoreText(original);
      expect(read).toMatchObject(rest);
      expect(toTargets(handles)).toEqual(toTargets(given));
      expect(read.companions).toEqual(
        companions && expect.objectContaining({ ...companions, variants: expect.anything() }),
      );
      expect(read.companions?.variants).toEqual(
        companions?.variants.map(({ name, steps: { handles: _, ...steps } }) => ({
          name,
          steps: expect.objectContaining(steps),
        })),
      );
      expect(await content({ ...read, handles })).toEqual(await content(original));
    },
  );

  it("hold a mesh that is text as text, which compresses", async () => {
    const rows = Array.from({ length: 400 }, (_, k) => `v ${k / 7} ${k / 3} ${(k * k) / 11}`);
    const file = `${rows.join("\r\n")}\nf 1 2 3 # Dachfl\u00e4che\n`;
    const bytes = new TextEncoder().encode(file);
    const source = {
      kind: "file",
      name: "a.obj",
      format: "obj",
      crc: crc32(bytes),
      bytes: new Blob([bytes]),
    } as const;
    const link = await encodeLink({ ...recipe, source });
    const read = opened(await decodeLink(link));
    expect(await content(read)).toEqual(bytes);
    const base64 = JSON.stringify({ bytes: Buffer.from(bytes).toString("base64") });
    expect(link.length).toBeLessThan(0.8 * packLink(base64).length);
  });

  it("are zlib and base64url, which every script has, with the dictionary or without", async () => {
    const text = JSON.stringify({ format: "planish-design", version: 1, name: "Dachfl\u00e4che" });
    const dictionary = Buffer.from(linkDictionary);
    const packed = Buffer.from(packLink(text).slice(4), "base64url");
    expect(inflateSync(packed, { dictionary }).toString()).toBe(text);
    const plain = deflateSync(text).toString("base64url");
    const preset = deflateSync(text, { dictionary }).toString("base64url");
    for (const link of [`#v2=${plain}`, `#v2=${preset}`, `#d1=${plain}`, packLink(text)])
      expect(await unpackLink(link)).toEqual({ ok: true, value: text });
    expect(preset.length).toBeLessThan(plain.length);
  });

  it("of an older page open: their dictionary is part of them", () => {
    expect(linkDictionary).toMatch(/^[ -~\n]*$/);
    expect(crc32(new TextEncoder().encode(linkDictionary))).toBe(0x73a20112);
  });

  it.each([
    ["with the dictionary", packLink(JSON.stringify({ format: "planish-design", name: "roof" }))],
    ["without", `#d1=${deflateSync('{"format":"planish-design"}').toString("base64url")}`],
  ])("%s say that they are damaged, whatever was changed or lost", async (_, link) => {
    const whole = opened(await unpackLink(link));
    for (let k = 4; k < link.length; k += 1) {
      const other = link[k] === "A" ? "B" : "A";
      const changed = await unpackLink(link.slice(0, k) + other + link.slice(k + 1));
      // A few bits are of no byte, or follow the end of what is compressed.
      if (changed.ok) expect(changed.value).toBe(whole);
      else expect(changed.reason).toMatch(/damaged|version/);
      expect(await unpackLink(link.slice(0, k))).toMatchObject({ ok: false });
    }
  });

  it("say what is wrong, whatever they are", async () => {
    const link = await encodeLink(recipe);
    const broken = ["", "#", "#x", "#v1=", "#v1=%%%", "#v1=AAAA", "#v2=", "#v2=%%%", "#v2=AAAA"];
    broken.push("#v9=abc", "#d2=abc", link.replace("v2", "v1"), FIRST.replace("v1", "v2"));
    for (const text of [link, FIRST])
      for (let cut = 4; cut < text.length; cut += 7) broken.push(text.slice(0, cut));
    for (let at = 4; at < FIRST.length; at += 5)
      broken.push(FIRST.slice(0, at) + (FIRST[at] === "A" ? "B" : "A") + FIRST.slice(at + 1));
    for (const text of broken) {
      const result = await decodeLink(text);
      expect(result, text).toMatchObject({ ok: false, reason: expect.stringMatching(/\.$/) });
    }
    expect(await unpackLink("#v9=a")).toMatchObject({
      reason: "This link is of version 9; this page reads versions 1 and 2. Reload the page.",
    });
  });
});

it("the checksum is the usual CRC-32", () => {
  expect(crc32(new TextEncoder().encode("123456789"))).toBe(0xcbf43926);
});

// SPDX-License-Identifier: MIT
// Whatever bytes they get, the decoders of links give a value or a reason: they
// do not throw, do not hang, do not take memory out of proportion, and give no half-valid value.
// PLANISH_FUZZ_INPUTS sets how many inputs each decoder gets, PLANISH_SEED the seed.
import { inflateRawSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { crc32 } from "../../web/src/bytes/crc32.ts";
import { recipeOf, type Steps } from "../../web/src/design/recipe.ts";
import { decodePayload } from "../../web/src/design/v1/link.ts";
import { isUnit } from "../../web/src/quantity/units.ts";
import { EDITED, MARK, OPENED } from "./support/golden-designs.ts";
import { GOLDEN_LINKS } from "./support/golden-links.ts";
import { decodeLink, encodeLink } from "./support/links.ts";
import { Damage, join } from "./support/mutations.ts";

const INPUTS = Number(process.env.PLANISH_FUZZ_INPUTS ?? 20_000);
const SEED = Number(process.env.PLANISH_SEED ?? 20_260_101);
/** Links are unpacked by the platform's streams, which takes longer than all the rest. */
const LINKS = process.env.PLANISH_FUZZ_INPUTS ? INPUTS : Math.ceil(INPUTS / 20);

const camera = { position: [1, 2, 3], target: [0, 0, 0] } as const;
const RECIPES = [recipeOf(EDITED, "m", camera, MARK), recipeOf(OPENED, "mm", null, MARK)];

const V1_LINKS = GOLDEN_LINKS.map(({ link }) => link);

/** A layout with a JSON part: where its length stands, where it begins, what the CRC covers. */
interface Layout {
  readonly length: number;
  readonly begin: number;
  readonly crc: number;
  readonly covered: number;
}
const PAYLOAD: Layout = { length: 4, begin: 8, crc: 0, covered: 4 };

/** Damage that the checksum does not notice, so that the readers behind it are reached. */
function sign(bytes: Uint8Array, layout: Layout): Uint8Array {
  if (bytes.length < layout.begin) return bytes;
  new DataView(bytes.buffer).setUint32(layout.crc, crc32(bytes.subarray(layout.covered)), true);
  return bytes;
}

function withJson(bytes: Uint8Array, layout: Layout, damage: Damage): Uint8Array {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const end = layout.begin + view.getUint32(layout.length, true);
  const value: unknown = JSON.parse(new TextDecoder().decode(bytes.subarray(layout.begin, end)));
  const text = new TextEncoder().encode(JSON.stringify(damage.json(value)));
  const changed = join(join(bytes.slice(0, layout.begin), text), bytes.subarray(end));
  new DataView(changed.buffer).setUint32(layout.length, text.length, true);
  return changed;
}

/** A damaged form of one of `originals`, two thirds of them signed as if they were whole. */
function damaged(originals: readonly Uint8Array[], layout: Layout, damage: Damage): Uint8Array {
  const original = damage.pick(originals);
  const other = damage.pick(originals);
  const bytes = damage.chance(0.6)
    ? withJson(original, layout, damage)
    : damage.bytes(original, other);
  return damage.chance(0.67) ? sign(bytes, layout) : bytes;
}

const finite = (numbers: Iterable<number>): boolean => [...numbers].every(Number.isFinite);
const index = (x: number): boolean => Number.isInteger(x) && x >= 0;

function whatIsWrongWithRecipe(recipe: Steps): string | null {
  const { handles, settings, families, unit, mark, source } = recipe;
  const { attraction, locality, smoothness } = settings;
  if (!handles.every(({ vertex, target }) => index(vertex) && finite(target))) return "handles";
  if (!finite([attraction, locality, smoothness])) return "settings";
  for (const { coefficients, asked } of families)
    if (!finite(coefficients) || asked < coefficients.length) return "families";
  if (!isUnit(unit) || (mark && !(index(mark.hash) && finite(mark.probes)))) return "unit or mark";
  return typeof source.name === "string" ? null : "source";
}

/** Runs `decode` on every input; gives how many were accepted. */
function fuzz(inputs: number, make: () => Uint8Array, judge: (bytes: Uint8Array) => string | null) {
  let accepted = 0;
  for (let k = 0; k < inputs; ++k) {
    const bytes = make();
    let wrong: string | null;
    try {
      wrong = judge(bytes);
    } catch (error) {
      wrong = `threw ${error}`;
    }
    if (wrong === "accepted") accepted += 1;
    else if (wrong) throw new Error(`seed ${SEED}, input ${k}: ${wrong}`);
  }
  return accepted;
}

describe("on damaged input", { timeout: 3_600_000 }, () => {
  it("a link's payload gives a recipe or nothing", async () => {
    const damage = new Damage(SEED);
    const originals = V1_LINKS.map((link) =>
      Uint8Array.from(inflateRawSync(Buffer.from(link.slice(4), "base64url"))),
    );
    const accepted = fuzz(
      INPUTS,
      () => damaged(originals, PAYLOAD, damage),
      (bytes) => {
        const recipe = decodePayload(bytes);
        return recipe && (whatIsWrongWithRecipe(recipe) ?? "accepted");
      },
    );
    expect(accepted).toBeGreaterThan(INPUTS / 100);
    expect(accepted).toBeLessThan(INPUTS / 2);
  });

  it("a link's text gives a recipe or a sentence", async () => {
    const damage = new Damage(SEED + 2);
    const links = [...(await Promise.all(RECIPES.map(encodeLink))), ...V1_LINKS];
    const text = new TextEncoder();
    for (let k = 0; k < LINKS; ++k) {
      const [link, other] = [damage.pick(links), damage.pick(links)];
      const bytes = damage.bytes(text.encode(link), text.encode(other));
      const read = await decodeLink(new TextDecoder().decode(bytes));
      if (read.ok) expect(whatIsWrongWithRecipe(read.value)).toBeNull();
      else expect(read.reason).toMatch(/^[A-Z].*\.$/);
    }
  });

  it("nothing was written into the prototypes", () => {
    expect(Object.hasOwn(Object.prototype, "polluted")).toBe(false);
    expect(({} as Record<string, unknown>).polluted).toBeUndefined();
  });
});

it("a link that unpacks to far more than any design is refused before it is unpacked", async () => {
  const zeros = new Blob([new Uint8Array(64 * 1024 * 1024)]).stream();
  const packed = await new Response(
    zeros.pipeThrough(new CompressionStream("deflate-raw")),
  ).arrayBuffer();
  const text = Buffer.from(packed).toString("base64url");
  expect(await decodeLink(`#v1=${text}`)).toMatchObject({
    ok: false,
    reason: expect.stringMatching(/damaged/),
  });
});

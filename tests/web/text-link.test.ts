// SPDX-License-Identifier: MIT
import { deflateSync } from "node:zlib";
import { expect, it } from "vitest";
import { isLink } from "../../web/src/design/fragment.ts";
import { isTextLink, unpackText } from "../../web/src/design/text-link.ts";

const TEXT = JSON.stringify({ format: "planish-design", version: 1, name: "Dachfläche" });
const LINK = `#d1=${deflateSync(TEXT).toString("base64url")}`;

it("zlib and base64url, which every script has, make a link that unpacks to the text", async () => {
  expect(isLink(LINK) && isTextLink(LINK)).toBe(true);
  expect(await unpackText(LINK)).toEqual({ ok: true, value: TEXT });
});

it("whatever character was changed or lost, a sentence says that the link is damaged", async () => {
  for (let k = 4; k < LINK.length; k += 1) {
    const other = LINK[k] === "A" ? "B" : "A";
    // The last characters may hold bits that no byte has.
    const changed = await unpackText(LINK.slice(0, k) + other + LINK.slice(k + 1));
    expect(changed.ok ? changed.value : changed.reason).toMatch(
      k < LINK.length - 1 ? /damaged/ : /damaged|planish-design/,
    );
    expect(await unpackText(LINK.slice(0, k))).toMatchObject({ ok: false });
  }
});

it("a link of another version says so", async () => {
  expect(await unpackText(LINK.replace("#d1", "#d2"))).toMatchObject({
    reason: expect.stringContaining("another version"),
  });
});

// SPDX-License-Identifier: MIT
// Before the solver is there the first sample is seen, but nothing where the address names a design.
import { expect, it } from "vitest";
import { paintFirst } from "../../web/src/app/first-paint.ts";
import { pageAlone } from "./support/page-here.ts";

const SQUARE = {
  positions: [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
  offsets: [0, 4],
  vertices: [0, 1, 2, 3],
};

it.each(["", "#guide"])("an address that ends with “%s” shows the first sample", (hash) => {
  const page = pageAlone();
  paintFirst(page, hash, SQUARE);
  expect(page.displayMesh.value?.display).toEqual(Float32Array.from(SQUARE.positions));
});

it.each(["#v2=eJyr", "#d1=abc"])(
  "one that ends with %s shows no mesh that is not the link's",
  (hash) => {
    const page = pageAlone();
    paintFirst(page, hash, SQUARE);
    expect(page.displayMesh.value).toBeNull();
  },
);

// SPDX-License-Identifier: MIT
import { expect, it } from "vitest";
import { continuedName } from "../../web/src/features/exploring/continuing.ts";

it("a design that goes on keeps its name and counts", () => {
  expect(continuedName("Freeform roof")).toBe("Freeform roof, continued.obj");
  expect(continuedName("roof.v2.ply")).toBe("roof.v2, continued.obj");
  expect(continuedName("roof, continued.obj")).toBe("roof, continued 2.obj");
  expect(continuedName("roof, continued 9.obj")).toBe("roof, continued 10.obj");
});

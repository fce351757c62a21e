// SPDX-License-Identifier: MIT
// What is said of panels that an edit spoilt or made hard to make.
import { newSliver, sliverAngle } from "virtual:core-defaults";
import { expect, it } from "vitest";
import { DAMAGES, damageWords, spoiltPanels } from "../../web/src/state/damage.ts";
import { TROUBLES, troublesOf } from "../../web/src/state/panel-trouble.ts";

/** Outline, shortest edge, smallest angle and change of each panel. */
const healthOf = (...angles: number[]): Float32Array =>
  Float32Array.from(angles.flatMap((angle) => [0, 1, angle, 1]));

it("what the core calls a sliver is what the page calls so", () => {
  expect(DAMAGES[newSliver]).toEqual(["became a sliver", "became slivers"]);
  const corners = healthOf(sliverAngle - 0.01, sliverAngle);
  expect([...troublesOf(corners, Uint8Array.of(0, 0))]).toEqual([TROUBLES.indexOf("sliver"), 0]);
});

it("says how sharp a new sliver is, after what is worse", () => {
  const health = healthOf(90, 12, 90, 8.5);
  expect(damageWords(Uint8Array.of(0, 0, 0, 0), health)).toBe("");
  expect(damageWords(Uint8Array.of(0, 5, 0, 0), health)).toBe(
    "1 panel became a sliver (corner 12°)",
  );
  expect(damageWords(Uint8Array.of(0, 5, 0, 5), health)).toBe(
    "2 panels became slivers (corners from 8.5°)",
  );
  const mixed = Uint8Array.of(0, 5, 4, 0);
  expect(damageWords(mixed, health)).toBe("1 panel became concave, 1 became a sliver (corner 12°)");
  expect(spoiltPanels(mixed)).toEqual([2, 1]);
});

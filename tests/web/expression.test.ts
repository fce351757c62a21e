// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { parseLength } from "../../web/src/quantity/expression.ts";
import { formatCoordinate, formatGap, formatLength } from "../../web/src/quantity/units.ts";

const read = (text: string, current = 0): number | string => {
  const parsed = parseLength(text, current, "m");
  return parsed.ok ? parsed.value : parsed.reason;
};

describe("typed coordinates", () => {
  it.each([
    ["1200", 1200],
    ["-3.5", -3.5],
    [".5", 0.5],
    ["1e-3", 1e-3],
    ["1,5", 1.5],
    ["1200mm", 1.2],
    ["1.2 m", 1.2],
    ["3*400mm", 1.2],
    ["10/4", 2.5],
    ["2*(1+3)", 8],
    ["(1+1)cm", 0.02],
    ["1'", 0.3048],
    ["1m-20cm", 0.8],
    ["-(2)", -2],
  ])("%s", (text, value) => {
    expect(read(text)).toBeCloseTo(value, 12);
  });

  it("adds what starts with a plus", () => {
    expect(read("+50mm", 2)).toBeCloseTo(2.05, 12);
    expect(read("+-1", 2)).toBe(1);
    expect(read("-1", 2)).toBe(-1);
  });

  it("adds and takes away what an equals sign says so of, and a minus alone is a sign", () => {
    expect(read("+=50mm", 2)).toBeCloseTo(2.05, 12);
    expect(read("-=50mm", 2)).toBeCloseTo(1.95, 12);
    expect(read(" -= 2*(1+3)", 2)).toBe(-6);
    expect(read("-=-1", 2)).toBe(3);
    expect(read("-50mm", 2)).toBeCloseTo(-0.05, 12);
    for (const text of ["-=", "+=", "=1", "- =1", "1-=2"]) expect(read(text)).toMatch(/\.$/);
  });

  it.each(["", "  ", "abc", "1 2", "1+", "(1", "1/0", "3 parsec", "--", "1..2", "NaN"])(
    "refuses %j with a sentence",
    (text) => {
      expect(read(text)).toMatch(/\.$/);
    },
  );
});

describe("lengths in words", () => {
  it.each([
    [0.182, "182 mm"],
    [0, "0 mm"],
    [0.0042, "4.2 mm"],
    [0.00001, "0.01 mm"],
    [12.34, "12.3 m"],
    [0.0000049, "< 0.01 mm"],
    [1e-15, "< 0.01 mm"],
  ])("%d m", (value, text) => {
    expect(formatLength(value, "m")).toBe(text);
  });

  it("shows flatness to a ten-thousandth of a millimetre", () => {
    expect(formatGap(1e-15, "m")).toBe("0.0000 mm");
    expect(formatGap(0.0000123, "m")).toBe("0.0123 mm");
    expect(formatGap(0.0155282, "m")).toBe("15.53 mm");
  });

  it("shows coordinates without idle zeros", () => {
    expect(formatCoordinate(12)).toBe("12");
    expect(formatCoordinate(-0.00001)).toBe("0");
    expect(formatCoordinate(1.23456)).toBe("1.2346");
  });
});

// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { FLAT, flatnessWords } from "../../web/src/design/flatness.ts";

const said = (gap: number, mmPerM: number): string =>
  flatnessWords(gap, mmPerM, mmPerM, "m").sentence;

describe("flatness in words", () => {
  it.each([0, 6e-13, 4.2e-8, FLAT])("%d mm/m is flat, and how flat that is", (mmPerM) => {
    expect(said(1e-16, mmPerM)).toBe("flat (< 0.000001 mm/m)");
    expect(flatnessWords(1e-16, mmPerM, mmPerM, "m").cell).toBe("flat");
  });

  it.each([
    [2.6e-9, 1.1e-6, "0.0000 mm out of flat (0.0000011 mm/m)"],
    [1e-6, 0.00025, "0.0010 mm out of flat (0.00025 mm/m)"],
    [0.0000123, 0.0123, "0.0123 mm out of flat (0.0123 mm/m)"],
    [0.02, 20, "20.00 mm out of flat (20.0 mm/m)"],
    [0.5, 1234.5, "500.0 mm out of flat (1235 mm/m)"],
  ])("%d m, %d mm/m: %s", (gap, mmPerM, words) => {
    expect(said(gap, mmPerM)).toBe(words);
  });

  it("is short where there is little room", () => {
    expect(flatnessWords(1e-16, 1e-13, 1e-13, "m").short).toBe("0.0000 mm, flat");
    expect(flatnessWords(1e-8, 1e-5, 1e-5, "m").short).toBe("0.0000 mm (0.000010 mm/m)");
  });

  it("calls flat but for rounding what its coordinates cannot hold flatter", () => {
    const words = flatnessWords(1e-8, 1e-5, 0, "m");
    expect(words.sentence).toBe("as flat as its coordinates can hold (0.000010 mm/m)");
    expect(words.short).toBe("0.0000 mm, flat but for rounding");
    expect(words.cell).toBe("0.000010");
    expect(flatnessWords(1e-16, 1e-13, 0, "m").short).toBe("0.0000 mm, flat");
  });

  it("never falls back on powers of ten, and never says flat of what is not", () => {
    for (let power = -5.99; power < 4; power += 0.37) {
      const words = said(10 ** power / 1000, 10 ** power);
      expect(words).toMatch(/^[\d.]+ mm out of flat \([\d.]+ mm\/m\)$/);
      expect(Number(/\(([\d.]+) /.exec(words)?.[1])).toBeGreaterThan(0.9 * 10 ** power);
    }
  });
});

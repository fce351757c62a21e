// SPDX-License-Identifier: MIT
import { describe, expect, it } from "vitest";
import { begin, record, redo, undo } from "../../web/src/design/history.ts";

describe("history", () => {
  const three = [1, 2, 3].reduce((history, n) => record(history, n), begin(0));

  it("undoes and redoes in order", () => {
    const back = undo(undo(three));
    expect(back.present).toBe(1);
    expect(redo(back).present).toBe(2);
    expect(redo(redo(back))).toEqual(three);
  });

  it("forgets the future after a new step", () => {
    expect(redo(record(undo(three), 9)).present).toBe(9);
  });

  it("stays as it is at both ends", () => {
    expect(undo(begin(0))).toEqual(begin(0));
    expect(redo(three)).toBe(three);
  });
});

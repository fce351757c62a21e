// SPDX-License-Identifier: MIT

import { done, type Result } from "../result/result.ts";
import type { ResultMark, Shape } from "../solver/protocol.ts";
import { runUnseen } from "./connection.ts";
import type { Page } from "./page.ts";

/** The mark by which a result is recognised. */
export async function readMark(page: Page, shape: Shape): Promise<Result<ResultMark>> {
  const answer = await runUnseen(page, "reading the result", { kind: "mark", shape }, "marked");
  return answer.ok ? done(answer.value.mark) : answer;
}

/** The mark where nobody asked for it: null if the solver cannot say. */
export async function markOf(page: Page, shape: Shape): Promise<ResultMark | null> {
  const read = await readMark(page, shape);
  return read.ok ? read.value : null;
}

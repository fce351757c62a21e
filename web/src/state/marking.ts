// SPDX-License-Identifier: MIT
import type { ResultMark, Shape } from "../solver/protocol.ts";
import { runUnseen } from "./connection.ts";

/** By what a result is recognised; null if the solver cannot say, which has been said then. */
export async function markOf(shape: Shape): Promise<ResultMark | null> {
  const answer = await runUnseen("reading the result", { kind: "mark", shape }, "marked");
  return answer?.mark ?? null;
}

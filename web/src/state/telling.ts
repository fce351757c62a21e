// SPDX-License-Identifier: MIT
// The alert of the page: what went wrong with the last thing that someone asked for. Operations return
// what came of them; what they are asked by (a queued action, a frame of a drag, a field) reports it here.
import type { Result } from "../result/result.ts";
import type { Page } from "./page.ts";

/** The only writer of page.problem. @param sentence null takes back what was said */
export function say(page: Page, sentence: string | null): void {
  page.problem.value = sentence;
}

/** What went well takes back what was said before; what was given up leaves it. */
export function report(page: Page, result: Result<unknown>): void {
  if (result.ok) say(page, null);
  else if (result.reason) say(page, result.reason);
}

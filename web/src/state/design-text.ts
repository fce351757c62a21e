// SPDX-License-Identifier: MIT
// A design's text, read by the core, and what a page kept beside it; within a queued action.
import { type Beside, readBeside } from "../design/beside-text.ts";
import { type DesignText, fromDesign } from "../design/design-value.ts";
import { done, type Result } from "../result/result.ts";
import { run } from "./connection.ts";
import type { Page } from "./page.ts";

/** @param label what the page is doing meanwhile */
export async function readText(
  page: Page,
  label: string,
  text: string,
): Promise<Result<DesignText & Beside>> {
  const read = async (text: string): Promise<Result<DesignText>> => {
    const answer = await run(page, label, { kind: "readDesign", text }, "design");
    return answer.ok ? fromDesign(answer.value.reading) : answer;
  };
  const design = await read(text);
  return design.ok ? done({ ...design.value, ...(await readBeside(text, read)) }) : design;
}

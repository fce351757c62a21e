// SPDX-License-Identifier: MIT
import { previewWords } from "../state/preview-words.ts";
import { usePage } from "./page-context.ts";

/** What the view shows of a planarising that is tried out. */
export function PreviewWords() {
  const page = usePage();
  const report = page.mesh.value?.report;
  return report ? previewWords(page, report) : null;
}

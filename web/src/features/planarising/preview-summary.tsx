// SPDX-License-Identifier: MIT

import { usePage } from "../../ui/page-context.ts";
import { previewWords } from "./preview-words.ts";

/** What the view shows of a planarising that is tried out. */
export function PreviewWords() {
  const page = usePage();
  const report = page.mesh.value?.report;
  return report ? previewWords(page, report) : null;
}

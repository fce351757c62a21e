// SPDX-License-Identifier: MIT

import { filesOfFormats } from "../solver/file-formats.ts";
import { fetchPart } from "../state/later.ts";
import type { Page } from "../state/page.ts";

/** Asks for one file; null if the user changes their mind. */
export function pickFile(accept: string): Promise<File | null> {
  return new Promise((resolve) => {
    const input = document.createElement("input");
    input.type = "file";
    input.accept = accept;
    input.addEventListener("change", () => resolve(input.files?.[0] ?? null));
    input.addEventListener("cancel", () => resolve(null));
    input.click();
  });
}

/** Opens a mesh or a design that was picked or dropped. */
export async function openGiven(page: Page, file: File): Promise<void> {
  const files = await fetchPart(page, () => import("../state/files.ts"));
  await files?.openFile(page, file);
}

export async function pickAndOpen(page: Page): Promise<void> {
  const file = await pickFile(filesOfFormats("3dm", "json"));
  if (file) await openGiven(page, file);
}

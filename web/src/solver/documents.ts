// SPDX-License-Identifier: MIT
// The module that reads and writes documents, fetched when it is needed for the first time.
import type { DocumentsModule } from "@wasm/planish_documents.mjs";
import documentsUrl from "@wasm/planish_documents.wasm?url";

/** A new instance each time: its memory, which only grows, goes with it. */
export async function loadDocuments(): Promise<DocumentsModule> {
  const { default: create } = await import("@wasm/planish_documents.mjs");
  return create({ locateFile: () => documentsUrl });
}

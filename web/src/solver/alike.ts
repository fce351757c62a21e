// SPDX-License-Identifier: MIT
// Panels are made more alike by the module of documents: no drag waits for what that takes.
import type { AlikeAsked, AlikeMesh } from "@wasm/planish_documents.mjs";
import { loadDocuments } from "./documents.ts";
import { Refused } from "./refused.ts";

/** @param obj the design; @param say gets the number of steps so far */
export async function makeAlike(
  obj: Uint8Array,
  asked: AlikeAsked,
  say: (steps: number) => void,
): Promise<AlikeMesh> {
  const documents = await loadDocuments().catch(() => {
    throw new Refused("The part that makes panels alike could not be loaded. Try again online.");
  });
  const made = documents.alike(obj, asked, say);
  if (made.problem) throw new Refused(`Panels cannot be made more alike: ${made.problem}.`);
  return made;
}

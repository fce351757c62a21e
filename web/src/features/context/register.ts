// SPDX-License-Identifier: MIT
import { followers } from "../../scene/followers.ts";
import type { Page } from "../../state/page.ts";
import { FileNotes } from "../../ui/places.ts";
import { followContext } from "./context-follower.ts";

export function register(page: Page): void {
  FileNotes.later(page, "ContextNote", () => import("./context-note.tsx"));
  followers(page).push(followContext);
}

// SPDX-License-Identifier: MIT
import { followers } from "../../scene/followers.ts";
import type { Page } from "../../state/page.ts";
import { ViewNotes } from "../../ui/places.ts";
import { followFinger } from "./finger-follower.ts";

export function register(page: Page): void {
  ViewNotes.later(page, "FingerOffer", () => import("./finger-offer.tsx"));
  followers(page).push(followFinger);
}

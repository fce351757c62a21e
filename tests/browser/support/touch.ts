// SPDX-License-Identifier: MIT
// A telephone, and fingers on its glass.
import type { CDPSession, Page } from "playwright-core";
import { site } from "./site.ts";
import type { Place } from "./view.ts";

/** Fingers on the glass, one place each. */
export type Touch = (
  type: "touchStart" | "touchMove" | "touchEnd",
  places: readonly Place[],
) => Promise<void>;

export async function openPhone(draws = false): Promise<{ page: Page; touch: Touch }> {
  const page = await site.open({
    draws,
    viewport: { width: 360, height: 740 },
    hasTouch: true,
    isMobile: true,
    reducedMotion: "reduce",
  });
  const session: CDPSession = await page.context().newCDPSession(page);
  const touch: Touch = async (type, places) => {
    const touchPoints = places.map(({ x, y }, id) => ({ x, y, id }));
    await session.send("Input.dispatchTouchEvent", { type, touchPoints });
  };
  return { page, touch };
}

/** Slides fingers from their places to others in steps, and lifts them. */
export async function slide(
  touch: Touch,
  from: readonly Place[],
  to: readonly Place[],
): Promise<void> {
  for (let k = 1; k <= from.length; ++k) await touch("touchStart", from.slice(0, k));
  for (let k = 1; k <= 6; ++k) {
    const between = from.map(({ x, y }, i) => ({
      x: x + (((to[i]?.x ?? x) - x) * k) / 6,
      y: y + (((to[i]?.y ?? y) - y) * k) / 6,
    }));
    await touch("touchMove", between);
  }
  await touch("touchEnd", []);
}

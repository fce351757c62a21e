// SPDX-License-Identifier: MIT
// Needs: layout.
// The page says why something cannot be done, what is selected, and what is being looked at.
import { expect, it } from "vitest";
import { typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

it("brings what Find variations gave into view", async () => {
  const page = await site.open({ viewport: { width: 1440, height: 900 } });
  await typeTarget(page, "+80cm");
  await page.getByRole("button", { name: "Find variations" }).click();
  const last = page.getByRole("slider", { name: "Variation 4", exact: true });
  await last.waitFor();
  const inspector = page.getByRole("complementary", { name: "Inspector" });
  const cutOff = async () => {
    const [slider, around] = [await last.boundingBox(), await inspector.boundingBox()];
    if (!slider || !around) return Number.POSITIVE_INFINITY;
    return slider.y + slider.height - (around.y + around.height);
  };
  await expect.poll(cutOff).toBeLessThanOrEqual(0);
  await page.context().close();
});

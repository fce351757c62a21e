// SPDX-License-Identifier: MIT
// Needs: network.
import { expect, it } from "vitest";
import { KEEPING } from "./support/open.ts";
import { exportAs, idle, openRule, status, typeTarget } from "./support/page.ts";
import { site } from "./support/site.ts";

it("works without a network after the first visit", async () => {
  const page = await site.open(KEEPING);
  await page.evaluate("navigator.serviceWorker.ready");
  await page.context().setOffline(true);
  await page.reload();
  await expect.poll(() => status(page)).toMatch(/0 of 425 points move/);
  expect((await exportAs(page, "OBJ")).length).toBeGreaterThan(1000);
  // What knows keep-outs is another module, which the first visit has not run.
  await openRule(page, "Keep-outs");
  await page.getByRole("button", { name: "Nothing may be above a level" }).click();
  await idle(page);
  await typeTarget(page, "+1.5");
  expect(await page.getByText(/^They hold \d+ points? of this edit back\.$/).count()).toBe(1);
  await page.context().close();
});

// SPDX-License-Identifier: MIT
import { afterAll, beforeAll } from "vitest";
import { openSite, type Site } from "./open.ts";

/** The built site, open while the tests of the file that imports it run. */
export let site: Site;

beforeAll(async () => {
  site = await openSite();
});
afterAll(() => site.close());

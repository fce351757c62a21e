// SPDX-License-Identifier: MIT
import { afterAll, beforeAll } from "vitest";
import { openSite, type Site } from "./open.ts";

/** The built site, open while a file of tests runs. */
export let site: Site;

/** Opens it for the tests of one file, and fails them for what its pages complained of. */
export function openForFile(): void {
  beforeAll(async () => {
    site = await openSite();
  });
  afterAll(() => site.close());
}

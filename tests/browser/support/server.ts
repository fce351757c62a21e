// SPDX-License-Identifier: MIT
// One browser and one server of the built site for all test files: vitest starts them before the first.
import type { TestProject } from "vitest/node";
import { launchServer } from "../../../.tools/page/browser.mjs";
import { serve } from "../../../.tools/page/serve.mjs";

declare module "vitest" {
  interface ProvidedContext {
    /** Where the browser listens for whoever drives it. */
    browser: string;
    /** The address of the page, under a sub-path. */
    site: string;
  }
}

/** PLANISH_SITE names another build to test, so that a long run survives the next one. */
export const SITE = process.env.PLANISH_SITE ?? "dist";

export default async function start(project: TestProject): Promise<() => Promise<void>> {
  const { server, url } = await serve(SITE, { prefix: "/under/a/path/" });
  const browser = await launchServer();
  project.provide("browser", browser.wsEndpoint());
  project.provide("site", url);
  return async () => {
    await browser.close();
    server.close();
  };
}

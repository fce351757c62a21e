// SPDX-License-Identifier: MIT
// How long tests wait, and which run at every commit. No figure of the product: a machine for CI may be half
// as fast, and shared.

const ci = Boolean(process.env.CI);

/** Milliseconds for one thing to happen. What has not happened by then does not happen: a red run ends soon. */
export const PATIENCE = ci ? 40_000 : 20_000;

/** Milliseconds for a test; longer ones say so themselves. */
export const TEST_LIMIT = ci ? 120_000 : 60_000;

/** Everything, however long: `npm run nightly`. */
export const NIGHTLY = process.env.PLANISH_NIGHTLY === "1";

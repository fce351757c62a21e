// SPDX-License-Identifier: MIT
// Drawing without a graphics card is half of what a page costs: where nobody looks at pixels, nothing is drawn.
import type { BrowserContext } from "playwright-core";

/** What is done to a visitor's browser before its first page loads. */
export type Prepare = (context: BrowserContext) => Promise<void>;

/** WebGL that does all but draw, in frames too: it compiles, holds buffers and clears. */
export const drawNothing: Prepare = async (context) => {
  await context.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    prototype.drawArrays = () => {};
    prototype.drawArraysInstanced = () => {};
    prototype.drawElements = () => {};
    prototype.drawElementsInstanced = () => {};
    prototype.drawRangeElements = () => {};
  });
};

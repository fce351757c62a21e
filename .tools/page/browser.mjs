// SPDX-License-Identifier: MIT
// The real browser of tests and scripts: Debian's Chromium without its window, drawing in software,
// without calls home.
import { chromium } from "playwright-core";

const FLAGS = [
  "--no-sandbox",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
  "--disable-background-networking",
  "--disable-component-update",
  "--disable-sync",
  "--no-first-run",
  // Text as wide as in a window.
  "--font-render-hinting=none",
];

/** With these a frame of the page costs a third less, a menu nothing. */
const QUICK = ["--disable-gpu-compositing", "--webgl-antialiasing-mode=none"];

const options = (smooth) => ({
  executablePath: "/usr/bin/chromium-headless-shell",
  args: smooth ? FLAGS : [...FLAGS, ...QUICK],
});

/** @param smooth draws edges as a person sees them, for pictures */
export const launch = ({ smooth = false } = {}) => chromium.launch(options(smooth));

/** One for several processes: each connects to its `wsEndpoint()` and has contexts of its own. */
export const launchServer = () => chromium.launchServer(options(false));

// SPDX-License-Identifier: MIT
// What reads and writes Rhino models is fetched when one comes.

import { Refused } from "./refused.ts";

export const rhinoPart = () =>
  import("./rhino.ts").catch(() => {
    throw new Refused("The part for Rhino could not be loaded. Try again online.");
  });

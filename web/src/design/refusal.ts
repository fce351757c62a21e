// SPDX-License-Identifier: MIT
// What a design that came from outside is refused with.
import { refuse } from "../result/result.ts";

export const DAMAGED_LINK = refuse(
  "This link is damaged: part of it is missing or was changed. Ask for it again.",
);

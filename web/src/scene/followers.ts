// SPDX-License-Identifier: MIT
import { kept } from "../state/page.ts";
import type { Palette } from "./palette.ts";
import type { Sight } from "./sight.ts";

/** Draws in the view, or helps there, for as long as it stands; returns how to stop. */
type Follower = (sight: Sight, palette: () => Palette) => () => void;

/** What features have in the view, in the order in which they start: after the structure and its colours. */
export const followers = kept((): Follower[] => []);

// SPDX-License-Identifier: MIT
import type { ComponentType } from "preact";
import { apart } from "./apart.tsx";

/** As apart(), but in one file with the other controls, which comes by itself once the page can be used. */
export const later = <P extends object>(load: () => Promise<ComponentType<P>>) => apart(load);

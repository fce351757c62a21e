// SPDX-License-Identifier: MIT
import { later } from "./later.tsx";

/** The "?" beside a control. */
export const Ask = later(() => import("./ask/ask-button.tsx").then((part) => part.AskButton));

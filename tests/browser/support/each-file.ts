// SPDX-License-Identifier: MIT
// What vitest does anew for each file of tests: they share two processes and their modules.
import { openForFile } from "./site.ts";

openForFile();

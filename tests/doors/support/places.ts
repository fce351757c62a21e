// SPDX-License-Identifier: MIT
import { join } from "node:path";

export const ROOT = new URL("../../..", import.meta.url).pathname;

/** With the wheel installed, as `bash .tools/start/wheel.sh` leaves it. */
export const PYTHON = process.env.PLANISH_PYTHON ?? join(ROOT, "build/python/venv/bin/python");

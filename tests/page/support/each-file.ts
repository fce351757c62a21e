// SPDX-License-Identifier: MIT
// What vitest does anew for each file of tests: they share one process, its modules and their surroundings.
import { afterEach, expect } from "vitest";
import { complaints, setPace } from "./surroundings.ts";

console.error = (...said: unknown[]) => complaints.push(said.map(String).join(" "));

afterEach(() => setPace("hurried"));

/** Fails the test in which the page logs an error. */
afterEach(() => expect(complaints.splice(0)).toEqual([]));

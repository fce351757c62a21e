// SPDX-License-Identifier: MIT
// The cutting package: written by the core, the same bytes as from the command line.
import type { CuttingHeader, CuttingOptions } from "../solver/protocol.ts";
import { run } from "../state/connection.ts";
import { designName, unit } from "../state/store.ts";
import { inTurn } from "../state/turns.ts";
import { save } from "./exporting.ts";

/** What the user chooses; the rest follows from the design. */
export type PackageChoice = Omit<CuttingOptions, "name" | "modelUnit">;

export const optionsOf = (choice: PackageChoice): CuttingOptions => ({
  ...choice,
  name: designName.value.replace(/\.[a-z]+$/i, ""),
  modelUnit: unit.value,
});

/** Saves the package of the design, once all that was asked for is done; null if it was refused. */
export async function exportPackage(choice: PackageChoice): Promise<CuttingHeader | null> {
  let header: CuttingHeader | null = null;
  await inTurn(async () => {
    const options = optionsOf(choice);
    const answer = await run("writing the package", { kind: "package", options }, "packaged");
    if (!answer) return;
    save(new Blob([answer.zip as BlobPart], { type: "application/zip" }), "-package.zip");
    header = answer.header;
  });
  return header;
}

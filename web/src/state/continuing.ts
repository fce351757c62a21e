// SPDX-License-Identifier: MIT
// The design as it stands becomes a mesh of its own, from which the next edits start.
import { run } from "./connection.ts";
import { continuedName } from "./continued-name.ts";
import { sourceName } from "./design.ts";
import { adopt } from "./opening.ts";
import { showPresent } from "./showing.ts";
import { history, notice } from "./store.ts";
import { inTurn } from "./turns.ts";

const SAID =
  "This shape is the new start: handles and variations are cleared. Undo brings them back.";

/** One step of the history; OBJ keeps every bit of every coordinate. */
export const continueFromShape = (): Promise<void> =>
  inTurn(async () => {
    const design = history.value?.present;
    if (!design || design.shape.moved.length === 0) return;
    const label = "starting from this shape";
    const written = await run(label, { kind: "export", format: "obj", design: null }, "exported");
    if (!written) return;
    const file = new Blob([written.bytes as BlobPart]);
    const name = continuedName(sourceName(design.source));
    const read = await run(label, { kind: "read", file, name, format: "obj" }, "opened");
    if (!read?.source) {
      await showPresent();
      return;
    }
    adopt(read.source, null, read.mesh);
    notice.value = SAID;
  });

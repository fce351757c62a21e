// SPDX-License-Identifier: MIT

import { useEffect } from "preact/hooks";
import { sourceName } from "../../design/design.ts";
import type { Snapshot } from "../../design/saved-record.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength } from "../../quantity/units.ts";
import type { Page } from "../../state/page.ts";
import {
  adoptSnapshot,
  deleteSnapshot,
  isShown,
  providePictures,
  renameSnapshot,
} from "../../state/snapshots.ts";
import { Ask } from "../../ui/ask.tsx";
import { CommandButton } from "../../ui/command-button.tsx";
import { COMMANDS } from "../../ui/commands/commands.ts";
import { useDoor } from "../../ui/commands/doors.ts";
import { useLaterDialog } from "../../ui/later-dialog.tsx";
import { DeleteButton, NameField } from "../../ui/name-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { COMPARE, chooseFirst, compareDoor } from "./comparing.ts";
import { snapshotPicture } from "./snapshot-picture.ts";
import "../../ui/designs.css";

/** The button that opens it, once there are two designs of the mesh. */
function CompareDialog() {
  const page = usePage();
  const { open, element } = useLaterDialog("compare", async () => {
    const { CompareDesigns } = await import("./compare-designs.tsx");
    chooseFirst(page);
    return { compare: { title: "Compare", wide: true, Content: CompareDesigns } };
  });
  useDoor(compareDoor, () => open("compare"));
  return (
    <>
      <CommandButton look="button wide" command={COMPARE} />
      {element}
    </>
  );
}

function figuresOf(page: Page, { design }: Snapshot): string {
  const { movedVertices, maxDisplacement } = design.report;
  if (movedVertices === 0) return "unchanged";
  return `${counted(movedVertices, "point")} · ${formatLength(maxDisplacement, page.unit.value)}`;
}

const CLOCK = new Intl.DateTimeFormat(undefined, { hour: "2-digit", minute: "2-digit" });

/** What tells one snapshot from another: its mesh; what moved, how far, and when it was taken. */
function Caption({ snapshot }: { snapshot: Snapshot }) {
  const page = usePage();
  const name = sourceName(snapshot.design.source);
  const figures = `${figuresOf(page, snapshot)} · ${CLOCK.format(snapshot.time)}`;
  return (
    <div title={`${name} · ${figures}`}>
      <span class="quiet small">{name}</span>
      <span class="quiet small">{figures}</span>
    </div>
  );
}

function Row({ snapshot }: { snapshot: Snapshot }) {
  const page = usePage();
  const { id, name } = snapshot;
  return (
    <li class="snapshot">
      <button
        type="button"
        class="tile"
        aria-pressed={isShown(page, snapshot)}
        aria-label={`Adopt ${name}`}
        onClick={() => void adoptSnapshot(page, id)}
      >
        {snapshot.picture && <img class="picture" src={snapshot.picture} alt="" />}
      </button>
      <div class="snapshot-words">
        <NameField name={name} onRename={(to) => renameSnapshot(page, id, to)} />
        <Caption snapshot={snapshot} />
      </div>
      <DeleteButton name={name} onDelete={() => deleteSnapshot(page, id)} />
    </li>
  );
}

/** Designs kept under a name. */
export function SnapshotsSection() {
  const page = usePage();
  useEffect(() => providePictures(page, (design) => snapshotPicture(page, design)), []);
  return (
    <section class="step" aria-labelledby="snapshots">
      <h2 id="snapshots">Snapshots</h2>
      <Ask about="snapshots" />
      <CommandButton look="button wide" command={COMMANDS.takeSnapshot} />
      {page.snapshots.value.length > 0 && <CompareDialog />}
      {page.snapshots.value.length > 0 && (
        <ul class="snapshots" aria-labelledby="snapshots">
          {page.snapshots.value.map((snapshot) => (
            <Row key={snapshot.id} snapshot={snapshot} />
          ))}
        </ul>
      )}
    </section>
  );
}

// SPDX-License-Identifier: MIT
import "./designs.css";
import { useEffect } from "preact/hooks";
import type { Snapshot } from "../share/saved-record.ts";
import { sourceName } from "../state/design.ts";
import {
  adoptSnapshot,
  deleteSnapshot,
  isShown,
  providePictures,
  renameSnapshot,
  takeSnapshot,
} from "../state/snapshots.ts";
import { ready, snapshots, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { CompareDialog } from "./compare-dialog.tsx";
import { Icon } from "./icon.tsx";
import { snapshotPicture } from "./snapshot-picture.ts";

function figuresOf({ design }: Snapshot): string {
  const { movedVertices, maxDisplacement } = design.report;
  if (movedVertices === 0) return "unchanged";
  const points = movedVertices === 1 ? "1 point" : `${movedVertices} points`;
  return `${points} · ${formatLength(maxDisplacement, unit.value)}`;
}

const CLOCK = new Intl.DateTimeFormat(undefined, { hour: "2-digit", minute: "2-digit" });

/** What tells one snapshot from another: its mesh; what moved, how far, and when it was taken. */
function Caption({ snapshot }: { snapshot: Snapshot }) {
  const name = sourceName(snapshot.design.source);
  const figures = `${figuresOf(snapshot)} · ${CLOCK.format(snapshot.time)}`;
  return (
    <div title={`${name} · ${figures}`}>
      <span class="quiet small">{name}</span>
      <span class="quiet small">{figures}</span>
    </div>
  );
}

function Row({ snapshot }: { snapshot: Snapshot }) {
  const { id, name } = snapshot;
  return (
    <li class="snapshot">
      <button
        type="button"
        class="tile"
        aria-pressed={isShown(snapshot)}
        aria-label={`Adopt ${name}`}
        onClick={() => void adoptSnapshot(id)}
      >
        {snapshot.picture && <img class="picture" src={snapshot.picture} alt="" />}
      </button>
      <div class="snapshot-words">
        <input
          type="text"
          class="snapshot-name"
          aria-label={`Name of ${name}`}
          value={name}
          maxLength={100}
          onChange={({ currentTarget }) => {
            renameSnapshot(id, currentTarget.value);
            currentTarget.value = snapshots.value.find((one) => one.id === id)?.name ?? name;
          }}
        />
        <Caption snapshot={snapshot} />
      </div>
      <button
        type="button"
        class="icon-button"
        aria-label={`Delete ${name}`}
        onClick={() => deleteSnapshot(id)}
      >
        <Icon name="close" />
      </button>
    </li>
  );
}

/** Designs kept under a name. */
export function SnapshotsSection() {
  useEffect(() => providePictures(snapshotPicture), []);
  return (
    <section class="step" aria-labelledby="snapshots">
      <h2 id="snapshots">Snapshots</h2>
      <button
        type="button"
        class="button wide"
        disabled={!ready.value}
        onClick={() => void takeSnapshot()}
      >
        Take snapshot
      </button>
      {snapshots.value.length > 0 && <CompareDialog />}
      {snapshots.value.length > 0 && (
        <ul class="snapshots" aria-labelledby="snapshots">
          {snapshots.value.map((snapshot) => (
            <Row key={snapshot.id} snapshot={snapshot} />
          ))}
        </ul>
      )}
    </section>
  );
}

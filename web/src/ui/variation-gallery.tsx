// SPDX-License-Identifier: MIT
import "./designs.css";
import { useComputed } from "@preact/signals";
import { flatnessWords } from "../state/flatness.ts";
import { adopt, type Gallery, type GalleryItem, gallery } from "../state/gallery.ts";
import { draft, mesh, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { type Patch, patchOf } from "./patch-drawing.ts";
import { PatchPicture } from "./patch-picture.tsx";

interface TileProps {
  readonly item: GalleryItem;
  readonly number: number;
  readonly patch: Patch;
}

function Tile({ item, number, patch }: TileProps) {
  const { movedVertices, maxDisplacement, worstGap, worstMmPerM, worstExcess } = item.report;
  const length = formatLength(maxDisplacement, unit.value);
  const worst = flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value).sentence;
  const chosen = draft.value?.shape === item.shape;
  const words = `${movedVertices} points move, largest ${length}, worst panel ${worst}`;
  return (
    <li>
      <button
        type="button"
        class="tile"
        aria-pressed={chosen}
        title={words}
        onClick={() => void adopt(item)}
      >
        {mesh.value && <PatchPicture mesh={mesh.value} patch={patch} shape={item.shape} />}
        <span class="visually-hidden">Adopt design {number}: </span>
        <span class="tile-figures">
          {length}
          <br />
          {movedVertices} points
        </span>
        <span class="visually-hidden">, worst panel {worst}</span>
      </button>
    </li>
  );
}

function Tiles({ shown, patch }: { shown: Gallery; patch: Patch }) {
  const { items, planned } = shown;
  const waiting = Math.max(0, planned - items.length);
  return (
    <ul class="tiles" aria-label="Gallery of variations" aria-busy={waiting > 0}>
      {items.map((item, k) => (
        <Tile key={item.coefficients.join()} item={item} number={k + 1} patch={patch} />
      ))}
      {Array.from({ length: waiting }, (_, k) => (
        <li key={`waiting ${items.length + k}`} class="tile waiting" aria-hidden="true" />
      ))}
    </ul>
  );
}

/** Designs to choose from, each exact already. */
export function VariationGallery() {
  const patch = useComputed(() => {
    const [opened, shown] = [mesh.value, gallery.value];
    if (!opened || !shown) return null;
    return patchOf(opened, [shown.centre, ...shown.items.map(({ shape }) => shape)]);
  });
  const shown = gallery.value;
  if (!shown || !patch.value || draft.value?.variation?.centre !== shown.centre) return null;
  return (
    <>
      <p class="quiet small">
        Designs to choose from, each flat already: its largest move and the points that move.
      </p>
      <Tiles shown={shown} patch={patch.value} />
    </>
  );
}

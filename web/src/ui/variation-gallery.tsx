// SPDX-License-Identifier: MIT
import "./designs.css";
import { useComputed } from "@preact/signals";
import { useMemo } from "preact/hooks";
import { flatnessWords } from "../state/flatness.ts";
import { foldWords, formatDegrees } from "../state/fold.ts";
import {
  adopt,
  fillGallery,
  type Gallery,
  type GalleryItem,
  gallery,
  preview,
} from "../state/gallery.ts";
import { draft, mesh, unit } from "../state/store.ts";
import { formatLength } from "../state/units.ts";
import { type Patch, patchOf, zoomedTo } from "./patch-drawing.ts";
import { PatchPicture } from "./patch-picture.tsx";

interface TileProps {
  readonly item: GalleryItem;
  readonly number: number;
  readonly patch: Patch;
}

/** "14 again"; what is spoilt is said, too. */
function Again({ panels }: Pick<GalleryItem, "panels">) {
  if (!panels) return null;
  return (
    <>
      <br />
      {`${panels.changed} again`}
      {panels.damage && <strong class="tile-damage">{panels.damage}</strong>}
    </>
  );
}

function Tile({ item, number, patch }: TileProps) {
  const { movedVertices, maxDisplacement, worstGap, worstMmPerM, worstExcess } = item.report;
  const length = formatLength(maxDisplacement, unit.value);
  const worst = flatnessWords(worstGap, worstMmPerM, worstExcess, unit.value).sentence;
  const chosen = draft.value?.shape === item.shape;
  const fold = foldWords(item.report);
  const words = `${movedVertices} points move, largest ${length}, worst panel ${worst}, ${fold}`;
  const after = item.report.sharpestFold?.after;
  const opened = mesh.value;
  const near = useMemo(
    () => (opened ? zoomedTo(opened, patch, item.shape) : patch),
    [opened, patch, item.shape],
  );
  return (
    <li>
      <button
        type="button"
        class="tile"
        aria-pressed={chosen}
        title={words}
        onClick={() => void adopt(item)}
        onPointerEnter={() => preview(item)}
        onPointerLeave={() => preview(null)}
        onFocus={() => preview(item)}
        onBlur={() => preview(null)}
      >
        {opened && <PatchPicture mesh={opened} patch={near} shape={item.shape} />}
        <span class="visually-hidden">Adopt design {number}: </span>
        <span class="tile-figures">
          {length}
          <br />
          {movedVertices} points
          {after !== undefined && (
            <>
              <br />
              {`fold ${formatDegrees(after)}`}
            </>
          )}
          <Again panels={item.panels} />
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

function GalleryButton() {
  return (
    <button type="button" class="button wide" onClick={() => void fillGallery()}>
      Show gallery
    </button>
  );
}

/** Designs to choose from, each exact already. */
export function VariationGallery() {
  const patch = useComputed(() => {
    const [opened, shown] = [mesh.value, gallery.value];
    if (!opened || !shown) return null;
    return patchOf(
      opened,
      shown.items.map(({ shape }) => shape),
      shown.centre,
    );
  });
  const [shown, centre] = [gallery.value, draft.value?.variation?.centre];
  if (!centre) return null;
  if (shown?.centre !== centre) return <GalleryButton />;
  if (!patch.value) return null;
  return (
    <>
      <p class="quiet small">
        Designs to choose from, each flat already, coloured by how far it is from the edit: blue
        towards you, amber away. Rest on one to see it in the view.
      </p>
      <Tiles shown={shown} patch={patch.value} />
    </>
  );
}

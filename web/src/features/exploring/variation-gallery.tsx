// SPDX-License-Identifier: MIT

import { useComputed, useSignal } from "@preact/signals";
import { useEffect, useMemo, useRef } from "preact/hooks";
import { flatnessWords } from "../../design/flatness.ts";
import { pointFrame } from "../../mesh/point-frame.ts";
import { counted } from "../../quantity/counted.ts";
import { formatLength } from "../../quantity/units.ts";
import { drawPatch, type Patch, patchOf, zoomedTo } from "../../scene/patch-drawing.ts";
import type { OpenedMesh, Shape } from "../../solver/protocol.ts";
import { shownPoint } from "../../state/editing.ts";
import { foldWords } from "../../state/fold.ts";
import type { Page } from "../../state/page.ts";
import { typeWords } from "../../state/type-counts.ts";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";
import { furthestBetween, signOf } from "./furthest.ts";
import {
  adopt,
  fillGallery,
  type Gallery,
  type GalleryItem,
  gallery,
  keep,
  preview,
  sameWithin,
} from "./gallery.ts";
import { wayWords } from "./slider-range.ts";
import "../../ui/designs.css";

/** CSS pixels where there is room; elsewhere it is shown smaller. */
const SIZE = [132, 88] as const;

interface PatchPictureProps {
  readonly mesh: OpenedMesh;
  readonly patch: Patch;
  readonly shape: Shape;
}

/** Decoration: what it shows is said in words beside it. */
function PatchPicture({ mesh, patch, shape }: PatchPictureProps) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const draw = (): void => {
      if (canvas.current) drawPatch(canvas.current, mesh, patch, shape, SIZE);
    };
    draw();
    const dark = window.matchMedia("(prefers-color-scheme: dark)");
    dark.addEventListener("change", draw);
    return () => dark.removeEventListener("change", draw);
  }, [mesh, patch, shape]);
  return (
    <span aria-hidden="true">
      <canvas ref={canvas} class="picture" />
    </span>
  );
}

/** How far it is from the edit, and which way; in words where, too: tiles may be the same in all other figures. */
function apartWords(page: Page, { shape }: GalleryItem, centre: Shape): readonly [string, string] {
  const opened = page.mesh.value;
  const found = opened && furthestBetween(centre, shape, opened.positions);
  if (!found) return ["", ""];
  const { vertex, move } = found;
  const frame = pointFrame(opened, (v) => shownPoint(page, v, centre), vertex);
  const length = formatLength(Math.hypot(...move), page.unit.value);
  const way = wayWords(move, frame.normal);
  return [`${signOf(move, frame)}${length}`, `from the edit ${length} at point ${vertex}, ${way}`];
}

interface TileProps {
  readonly item: GalleryItem;
  readonly number: number;
  readonly patch: Patch;
  /** The edit that it is a variation of. */
  readonly centre: Shape;
  /** Takes what is pointed at; null: none any more. */
  readonly onPoint: (item: GalleryItem | null) => void;
}

/** "14 panels to make again"; types, where they were asked for, and what is spoilt are said, too. */
const panelWords = ({ panels }: GalleryItem): readonly string[] =>
  panels
    ? [
        `${counted(panels.changed, "panel")} to make again`,
        panels.types ? typeWords(panels.types) : "",
        panels.damage,
      ]
    : [];

/** Everything that is known of a tile's design but its number. */
function aboutWords(page: Page, item: GalleryItem, centre: Shape): string {
  const [, apart] = apartWords(page, item, centre);
  const { movedVertices, maxDisplacement, worstGap, worstMmPerM, worstExcess } = item.report;
  const length = formatLength(maxDisplacement, page.unit.value);
  const worst = flatnessWords(worstGap, worstMmPerM, worstExcess, page.unit.value).sentence;
  const words = [
    `${movedVertices} points move`,
    `largest ${length}`,
    apart,
    `worst panel ${worst}`,
    foldWords(item.report),
    ...panelWords(item),
  ];
  return words.filter(Boolean).join(", ");
}

function KeepButton({ item, number }: Pick<TileProps, "item" | "number">) {
  const page = usePage();
  const kept = page.snapshots.value.find(({ design }) => design.shape === item.shape);
  return (
    <button
      type="button"
      class="icon-button keep-variation"
      aria-label={`Snapshot of design ${number}`}
      title={kept ? `Kept as ${kept.name}` : "Keep it as a snapshot; the design shown stays"}
      disabled={kept !== undefined || !page.ready.value}
      onClick={() => void keep(page, item)}
    >
      <Icon name="camera" />
    </button>
  );
}

function Tile({ item, number, patch, centre, onPoint }: TileProps) {
  const page = usePage();
  const chosen = page.draft.value?.shape === item.shape;
  const [apart] = apartWords(page, item, centre);
  const opened = page.mesh.value;
  const near = useMemo(
    () => (opened ? zoomedTo(opened, patch, item.shape) : patch),
    [opened, patch, item.shape],
  );
  return (
    <li class="variation">
      <button
        type="button"
        class="tile"
        aria-pressed={chosen}
        title={aboutWords(page, item, centre)}
        onClick={() => void adopt(page, item)}
        onPointerEnter={() => onPoint(item)}
        onPointerLeave={() => onPoint(null)}
        onFocus={() => onPoint(item)}
        onBlur={() => onPoint(null)}
      >
        {opened && <PatchPicture mesh={opened} patch={near} shape={item.shape} />}
        <span class="tile-figures" aria-hidden="true">
          {apart}
        </span>
        {item.panels?.damage && (
          <strong class="tile-damage" aria-hidden="true">
            spoilt
          </strong>
        )}
        <span class="visually-hidden">
          {apart ? `Adopt design ${number}, ${apart}` : `Adopt design ${number}`}
        </span>
      </button>
      <KeepButton item={item} number={number} />
    </li>
  );
}

/** What is known of the design pointed at or chosen: a finger finds no title. */
function TileWords({ shown, item }: { shown: Gallery; item: GalleryItem | null }) {
  const page = usePage();
  const told = item ?? shown.items.find(({ shape }) => shape === page.draft.value?.shape);
  if (!told) return <p class="quiet small">Press one for its figures.</p>;
  const number = shown.items.indexOf(told) + 1;
  return <p class="quiet small">{`Design ${number}: ${aboutWords(page, told, shown.centre)}.`}</p>;
}

function Tiles({ shown, patch }: { shown: Gallery; patch: Patch }) {
  const page = usePage();
  const pointed = useSignal<GalleryItem | null>(null);
  const { items, planned, centre } = shown;
  const waiting = Math.max(0, planned - items.length);
  const point = (item: GalleryItem | null): void => {
    pointed.value = item;
    preview(page, item);
  };
  return (
    <>
      <ul class="tiles" aria-label="Gallery of variations" aria-busy={waiting > 0}>
        {items.map((item, k) => (
          <Tile
            key={item.coefficients.join()}
            item={item}
            number={k + 1}
            patch={patch}
            centre={centre}
            onPoint={point}
          />
        ))}
        {Array.from({ length: waiting }, (_, k) => (
          <li key={`waiting ${items.length + k}`} class="tile waiting" aria-hidden="true" />
        ))}
      </ul>
      <TileWords shown={shown} item={pointed.value} />
    </>
  );
}

function GalleryButton() {
  const page = usePage();
  return (
    <button type="button" class="button wide" onClick={() => void fillGallery(page)}>
      Show gallery
    </button>
  );
}

function alikeWords(page: Page, { alike, centre, items }: Gallery): string {
  const opened = page.mesh.value;
  const length = formatLength(opened ? sameWithin(centre, opened.positions) : 0, page.unit.value);
  if (items.length === 0) return `All that were tried are within ${length} of the edit.`;
  const others = alike === 1 ? "One more was tried, and is" : `${alike} more were tried, and are`;
  return `${others} within ${length} of the edit or of one of these.`;
}

/** Designs to choose from, each exact already. */
export function VariationGallery() {
  const page = usePage();
  const patch = useComputed(() => {
    const [opened, shown] = [page.mesh.value, gallery(page).value];
    if (!opened || !shown) return null;
    return patchOf(
      opened,
      shown.items.map(({ shape }) => shape),
      shown.centre,
    );
  });
  const [shown, centre] = [gallery(page).value, page.draft.value?.variation?.centre];
  if (!centre) return null;
  if (shown?.centre !== centre) return <GalleryButton />;
  if (!patch.value) return null;
  return (
    <>
      <p class="quiet small">
        Each is flat already. The picture is blue where it comes towards you, green where it goes
        away. Under it: how far at most from the edit, + out of the surface.
      </p>
      <Tiles shown={shown} patch={patch.value} />
      {shown.alike > 0 && <p class="quiet small">{alikeWords(page, shown)}</p>}
    </>
  );
}

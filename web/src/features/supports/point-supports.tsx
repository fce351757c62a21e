// SPDX-License-Identifier: MIT
// What single points stand on: they slide along it and never leave it.
import { useEffect } from "preact/hooks";
import "./point-supports.css";
import { FIRST_SETTINGS } from "../../design/design.ts";
import { POLYLINE } from "../../design/listed-supports.ts";
import { areAllOnSurface, withAllOnSurface } from "../../design/supports.ts";
import { counted } from "../../quantity/counted.ts";
import { commitSettings } from "../../state/editing.ts";
import { Ask } from "../../ui/ask.tsx";
import { Choice } from "../../ui/choice.tsx";
import { usePage } from "../../ui/page-context.ts";
import {
  followSupports,
  isBoundarySelected,
  isLineSelected,
  standing,
  standOfSelected,
  standOn,
} from "./supports.ts";

const STANDS: readonly (readonly [string, string])[] = [
  ["", "move freely"],
  ["level=z", "keep their level"],
  ["level=x level=y", "only go up and down"],
  ["level=y level=z", "only go along x"],
  ["level=x level=z", "only go along y"],
  ["level=x", "keep their x"],
  ["level=y", "keep their y"],
  ["surface", "stay on the surface"],
];

/** The polygon that the boundary is drawn as; other points have none. */
const OUTLINE = ["outline", "stay on the outline"] as const;

/** The polygon of the mesh through the selected points, where they are one line. */
const LINE = [POLYLINE, "stay on their line"] as const;

const MIXED = ["mixed", "stand on different things"] as const;

const wordsOf = (stand: string): string =>
  [...STANDS, OUTLINE, LINE].find(([form]) => form === stand)?.[1] ?? `stay on ${stand}`;

/** By what they stand on. */
function groups(stands: ReadonlyMap<number, string>): Map<string, number[]> {
  const all = new Map<string, number[]>();
  for (const [vertex, stand] of stands) all.set(stand, [...(all.get(stand) ?? []), vertex]);
  return all;
}

function Group({ stand, points }: { stand: string; points: readonly number[] }) {
  const page = usePage();
  const said = `${counted(points.length, "point")}: ${wordsOf(stand)}`;
  return (
    <li class="support-group">
      <span>{said}</span>
      <button
        type="button"
        class="tool"
        aria-description={said}
        onClick={() => {
          page.selection.value = points;
        }}
      >
        Select
      </button>
      <button
        type="button"
        class="tool"
        aria-description={said}
        disabled={!page.ready.value}
        onClick={() => void standOn(page, points, "")}
      >
        Let go
      </button>
    </li>
  );
}

function StandOfSelected() {
  const page = usePage();
  const chosen = page.selection.value;
  const stand = standOfSelected(page);
  const known = [
    ...STANDS,
    ...(isBoundarySelected(page) ? [OUTLINE] : []),
    ...(isLineSelected(page) ? [LINE] : []),
  ];
  const other = stand === null ? MIXED : ([stand, wordsOf(stand)] as const);
  const words = known.some(([form]) => form === other[0]) ? known : [other, ...known];
  return (
    <Choice
      label={`Selected: ${counted(chosen.length, "point")}`}
      value={other[0]}
      words={words}
      onChoose={(form) => {
        if (form !== MIXED[0]) void standOn(page, chosen, form);
      }}
    />
  );
}

/** The shape stays, and the joints between panels move along it. */
function AllOnSurface() {
  const page = usePage();
  const { supports } = page.settings.value ?? FIRST_SETTINGS;
  return (
    <label class="check all-on-surface">
      <input
        type="checkbox"
        checked={areAllOnSurface(supports)}
        disabled={!page.ready.value}
        onChange={({ currentTarget }) =>
          void commitSettings(page, {
            supports: withAllOnSurface(supports, currentTarget.checked),
          })
        }
      />
      <span>All points stay on the surface</span>
    </label>
  );
}

export function PointSupports() {
  const page = usePage();
  useEffect(() => followSupports(page), []);
  const none = page.selection.value.length === 0;
  const listed = groups(standing(page));
  return (
    <>
      <Ask about="supports" />
      <AllOnSurface />
      {none ? <p class="quiet">Select a point first.</p> : <StandOfSelected />}
      <ul class="support-groups">
        {[...listed].map(([stand, points]) => (
          <Group key={stand} stand={stand} points={points} />
        ))}
      </ul>
      <p class="quiet">
        Points slide along what they stand on and never leave it, wherever the edit takes them.
        Pinned points do not move at all.
      </p>
    </>
  );
}

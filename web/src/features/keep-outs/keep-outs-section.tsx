// SPDX-License-Identifier: MIT
// Where nothing of an edit may go: below a level, above one, beyond a plane, into a box, through the
// structure itself.

import { useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import "../../ui/keep-out-rows.css";
import "./keep-outs.css";
import type { KeepOut, KeepOutKind } from "../../design/keep-outs.ts";
import { counted } from "../../quantity/counted.ts";
import { filesOfFormats, namesOfFormats } from "../../solver/file-formats.ts";
import type { Page } from "../../state/page.ts";
import { Ask } from "../../ui/ask.tsx";
import { Icon } from "../../ui/icon.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { pickFile } from "../../ui/pick-file.ts";
import { viewOf } from "../../ui/view-slot.ts";
import { followKeepOuts } from "./keep-out-follower.ts";
import {
  addKeepOut,
  addModel,
  changeKeepOut,
  clearanceOf,
  heldByKeepOuts,
  keepClear,
  keepOuts,
  movedInView,
  removeKeepOut,
  removeKeepOuts,
} from "./keep-outs.ts";

interface Words {
  /** On the button that adds one; none where a file says what it is. */
  readonly add?: string;
  readonly name: string;
  readonly about: string;
  /** A row each; without a unit where the numbers are a direction. */
  readonly rows: readonly {
    readonly label: string;
    readonly axes: readonly string[];
    readonly plain?: true;
  }[];
}

const XYZ = ["X", "Y", "Z"] as const;

const WORDS: Readonly<Record<KeepOutKind, Words>> = {
  below: {
    add: "below a level",
    name: "Nothing below",
    about: "no point may be lower",
    rows: [{ label: "level", axes: ["Z"] }],
  },
  above: {
    add: "above a level",
    name: "Nothing above",
    about: "no point may be higher",
    rows: [{ label: "level", axes: ["Z"] }],
  },
  plane: {
    add: "beyond a plane",
    name: "Nothing beyond a plane",
    about: "no point may be where a·x + b·y + c·z is more than d",
    rows: [
      { label: "towards", axes: ["a", "b", "c"], plain: true },
      { label: "at", axes: ["d"] },
    ],
  },
  box: {
    add: "in a box",
    name: "Nothing in a box",
    about: "no panel may enter it",
    rows: [
      { label: "from", axes: XYZ },
      { label: "to", axes: XYZ },
    ],
  },
  self: {
    add: "through itself",
    name: "No panel through another",
    about: "those that share no point do not touch",
    rows: [],
  },
  mesh: { name: "No panel through a model", about: "it stays where it stands", rows: [] },
};

const KINDS = ["below", "above", "plane", "box", "self"] as const;

/** Which of several alike. */
function nameOf(all: readonly KeepOut[], place: number): string {
  const kind = all[place]?.kind ?? "box";
  const alike = all.filter((one) => one.kind === kind).length;
  const nth = all.slice(0, place + 1).filter((one) => one.kind === kind).length;
  return alike > 1 ? `${WORDS[kind].name} ${nth}` : WORDS[kind].name;
}

function Numbers({ place }: { place: number }) {
  const page = usePage();
  /** Typed and refused. */
  const typed = useSignal<readonly number[] | null>(null);
  const refused = useSignal("");
  const all = keepOuts(page).value;
  const one = all[place];
  if (!one) return null;
  const { about, rows } = WORDS[one.kind];
  const numbers = typed.value ?? one.numbers;
  const apply = async (wanted: readonly number[]): Promise<void> => {
    typed.value = wanted;
    refused.value = "";
    const end = await changeKeepOut(page, place, { kind: one.kind, numbers: wanted });
    if (end && !end.ok) refused.value = end.reason;
    else typed.value = null;
  };
  let first = 0;
  return (
    <>
      {rows.map(({ label, axes, plain: direction }) => {
        const begin = first;
        first += axes.length;
        return (
          <div key={label} class="keep-out-row">
            <span class="quiet small">{label}</span>
            {axes.map((axis, k) => (
              <LimitField
                key={axis}
                label={`${nameOf(all, place)}, ${label} ${axis}`}
                about={refused.value || `${direction ? "" : `${page.unit.value}, `}${about}`}
                value={numbers[begin + k] ?? 0}
                unit={direction ? null : page.unit.value}
                invalid={refused.value !== ""}
                onApply={(given) =>
                  void apply(numbers.map((x, other) => (other === begin + k ? given : x)))
                }
              />
            ))}
            <span class="unit quiet small">{direction ? "" : page.unit.value}</span>
          </div>
        );
      })}
      {refused.value && (
        <p class="refused small" role="alert">
          {refused.value}
        </p>
      )}
    </>
  );
}

function Row({ place }: { place: number }) {
  const page = usePage();
  const all = keepOuts(page).value;
  const kind = all[place]?.kind;
  if (!kind) return null;
  const [name, moved] = [nameOf(all, place), movedInView(page)];
  const isMoved = moved.value === place;
  return (
    <li class="keep-out">
      <div class="keep-out-head">
        <span>{name}</span>
        {kind !== "self" && (
          <button
            type="button"
            class="tool"
            aria-pressed={isMoved}
            aria-label={`Move in the view: ${name}`}
            disabled={!page.ready.value}
            onClick={() => {
              moved.value = isMoved ? null : place;
            }}
          >
            Move
          </button>
        )}
        <button
          type="button"
          class="icon-button"
          aria-label={`Remove: ${name}`}
          disabled={!page.ready.value}
          onClick={() => void removeKeepOut(page, place)}
        >
          <Icon name="close" />
        </button>
      </div>
      <Numbers place={place} />
    </li>
  );
}

async function pickModel(page: Page): Promise<void> {
  const file = await pickFile(filesOfFormats());
  if (file) await addModel(page, file);
}

function Add() {
  const page = usePage();
  const all = keepOuts(page).value;
  return (
    <fieldset class="keep-out-kinds">
      <legend class="quiet small">Nothing may be</legend>
      {KINDS.map((kind) => (
        <button
          key={kind}
          type="button"
          class="tool"
          title={WORDS[kind].about}
          aria-label={`Nothing may be ${WORDS[kind].add}`}
          disabled={!page.ready.value || (kind === "self" && all.some((one) => one.kind === kind))}
          onClick={() => void addKeepOut(page, kind)}
        >
          {WORDS[kind].add}
        </button>
      ))}
      <button
        type="button"
        class="tool"
        title={`From an ${namesOfFormats()} file: no panel goes through one of its own`}
        aria-label="Nothing may be through a model"
        disabled={!page.ready.value}
        onClick={() => void pickModel(page)}
      >
        through a model…
      </button>
    </fieldset>
  );
}

/** What there is to say once there are any. */
function Kept() {
  const page = usePage();
  const refused = useSignal("");
  const held = heldByKeepOuts(page);
  const stay = async (clearance: number): Promise<void> => {
    const end = await keepClear(page, clearance);
    refused.value = end && !end.ok ? end.reason : "";
  };
  return (
    <>
      <ul class="keep-outs">
        {keepOuts(page).value.map((one, place) => (
          <Row key={`${place} ${one.kind}`} place={place} />
        ))}
      </ul>
      <div class="keep-out-row">
        <span class="quiet small">Clearance</span>
        <LimitField
          label="Clearance"
          about={refused.value || `${page.unit.value}, kept from each of them`}
          value={clearanceOf(page)}
          unit={page.unit.value}
          invalid={refused.value !== ""}
          onApply={(given) => void stay(given)}
        />
        <button
          type="button"
          class="button small"
          disabled={!page.ready.value}
          onClick={() => void removeKeepOuts(page)}
        >
          Remove all
        </button>
        <span class="unit quiet small">{page.unit.value}</span>
      </div>
      {refused.value && (
        <p class="refused small" role="alert">
          {refused.value}
        </p>
      )}
      {held.length > 0 && <p>{`They hold ${counted(held.length, "point")} of this edit back.`}</p>}
    </>
  );
}

export function KeepOuts() {
  const page = usePage();
  useEffect(() => {
    const view = viewOf(page);
    return view ? followKeepOuts(page, view.stage) : undefined;
  }, []);
  const some = keepOuts(page).value.length;
  return (
    <>
      <Ask about="keepOuts" />
      <Add />
      {some > 0 && <Kept />}
      <p class="quiet small">
        What is there already goes no deeper, may come out, and blocks nothing else.
      </p>
    </>
  );
}

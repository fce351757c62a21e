// SPDX-License-Identifier: MIT
// The tool that cuts panels: what clicks in the view do, the same by numbers, and the cuts made so far.
import { useLayoutEffect, useRef } from "preact/hooks";
import { Ask } from "../../ui/ask.tsx";
import { Icon } from "../../ui/icon.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { viewOf } from "../../ui/view-slot.ts";
import { followCutting } from "./cut-follower.ts";
import { otherSide } from "./cut-selection.ts";
import { CUT_KINDS, type CutKind, cutWords, kindWord } from "./cut-text.ts";
import { giveUpCut } from "./cut-tool.ts";
import { cuts, removeCuts } from "./cuts.ts";
import {
  begun,
  chooseKind,
  collar,
  cornerShare,
  cutKind,
  cutNow,
  numbers,
  refusalNow,
  type,
  wantedCut,
} from "./cutting.ts";
import "./cut-strip.css";

interface Words {
  /** What to click. */
  readonly how: string;
  readonly label: string;
  /** How the numbers are typed. */
  readonly form: string;
}

const WORDS: Readonly<Record<CutKind, Words>> = {
  split: {
    how: "Click two corners or sides of one panel.",
    label: "Panel:from,to",
    form: "7:12,40-41@0.3",
  },
  strip: {
    how: "Click a side: a line of points goes through the strip of quads across it.",
    label: "Side",
    form: "12-13@0.4",
  },
  corner: {
    how: "Click a panel near the corner that becomes a triangle.",
    label: "Panel:corner",
    form: "40:79",
  },
  refine: {
    how: "Click a panel, or select several points or panels first.",
    label: "Panels",
    form: "7,8",
  },
  trim: {
    how: "What lies beyond a plane goes: through the selected points, or where Section cuts the view.",
    label: "Plane a,b,c,d",
    form: "0,0,1,2.5",
  },
};

const PICTURE_OF = {
  split: "cut",
  strip: "cutStrip",
  corner: "cutCorner",
  refine: "cut",
  trim: "cut",
} as const satisfies Readonly<Record<CutKind, string>>;

function Kinds() {
  const page = usePage();
  const chosen = cutKind(page).value;
  return (
    <div class="cut-kinds">
      {CUT_KINDS.map((kind) => (
        <button
          key={kind}
          type="button"
          class="tool"
          aria-pressed={kind === chosen}
          onClick={() => chooseKind(page, kind)}
        >
          {kindWord(kind)}
        </button>
      ))}
      <Ask about={PICTURE_OF[chosen]} />
      <button
        type="button"
        class="icon-button"
        aria-label="Stop cutting"
        title="Stop cutting (Escape)"
        onClick={() => {
          page.cutting.value = false;
        }}
      >
        <Icon name="close" />
      </button>
    </div>
  );
}

/** What one kind has beside its numbers. */
function Options() {
  const page = usePage();
  const kind = cutKind(page).value;
  if (kind === "corner")
    return (
      <span class="cut-share">
        at
        <LimitField
          label="Share of the sides"
          about="where the cut meets the two sides; 1: at the next corners, and no point is added"
          value={cornerShare(page).value}
          unit={null}
          invalid={!(cornerShare(page).value > 0 && cornerShare(page).value <= 1)}
          onApply={(share) => {
            cornerShare(page).value = share;
          }}
        />
      </span>
    );
  if (kind === "refine")
    return (
      <label class="check" title="Splits the panels beside, so that none has a straight corner">
        <input
          type="checkbox"
          checked={collar(page).value}
          onChange={({ currentTarget }) => {
            collar(page).value = currentTarget.checked;
          }}
        />
        <span>Split those beside</span>
      </label>
    );
  if (kind !== "trim") return null;
  return (
    <button
      type="button"
      class="tool"
      title="Removes what lies on the other side of the plane"
      disabled={numbers(page) === ""}
      onClick={() => type(page, otherSide(numbers(page)))}
    >
      Other side
    </button>
  );
}

/** A cut without a pointer: by numbers, which the selection fills in. */
function Form() {
  const page = usePage();
  const kind = cutKind(page).value;
  const { label, form } = WORDS[kind];
  return (
    <form
      class="cut-form"
      onSubmit={(event) => {
        event.preventDefault();
        void cutNow(page);
      }}
    >
      <label>
        {label}
        <input
          type="text"
          class="number"
          autocomplete="off"
          spellcheck={false}
          placeholder={form}
          disabled={!page.ready.value}
          value={numbers(page)}
          onInput={({ currentTarget }) => type(page, currentTarget.value)}
        />
      </label>
      <Options />
      <button type="submit" class="button small" disabled={wantedCut(page).value === null}>
        Cut
      </button>
    </form>
  );
}

function List() {
  const page = usePage();
  const all = cuts(page).value;
  if (all.length === 0) return null;
  const rest = (k: number): number => all.length - 1 - k;
  return (
    <ol class="cut-list" aria-label="Cuts made">
      {all.map((text, k) => (
        <li key={`${k} ${text}`}>
          <span>{cutWords(text)}</span>
          <button
            type="button"
            class="tool"
            title={
              rest(k) > 0
                ? `Removes this cut and the ${rest(k)} after it`
                : "Removes this cut; an edit is solved again without it"
            }
            aria-label={`Remove: ${cutWords(text)}${rest(k) > 0 ? ` and the ${rest(k)} after it` : ""}`}
            disabled={!page.ready.value}
            onClick={() => void removeCuts(page, k)}
          >
            {rest(k) > 0 ? "Remove from here" : "Remove"}
          </button>
        </li>
      ))}
    </ol>
  );
}

function CutStrip() {
  const page = usePage();
  const strip = useRef<HTMLElement>(null);
  // Clicks are the tool's from the first frame of the strip and not any more once it has gone.
  useLayoutEffect(() => {
    strip.current?.scrollIntoView?.({ block: "nearest" });
    return followCutting(page, viewOf(page));
  }, []);
  const refusal = refusalNow(page);
  const how = begun(page)
    ? "Click the other end on the same panel."
    : WORDS[cutKind(page).value].how;
  return (
    <section
      ref={strip}
      class="cut-strip"
      aria-label="Cut panels"
      onKeyDown={({ key }) => {
        if (key === "Escape") giveUpCut(page);
      }}
    >
      <Kinds />
      <p class="quiet">{how}</p>
      <Form />
      <p class="refused" aria-live="polite">
        {refusal}
      </p>
      <List />
    </section>
  );
}

/** Beside the view while clicks in it cut. */
export const CutStrips = () => (usePage().cutting.value ? <CutStrip /> : null);

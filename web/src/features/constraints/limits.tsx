// SPDX-License-Identifier: MIT
// What the shop or the eye allows: limits on folds, angles, lengths and sizes of panels, and on how far
// joints slide, each on or off.

import type { Page } from "../../state/page.ts";
import { Check } from "../../ui/check.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./limits.css";
import { useSignal } from "@preact/signals";
import { FIRST_SETTINGS } from "../../design/design.ts";
import { limitHead, limitNumbers } from "../../design/stated-limit.ts";
import { niceStep } from "../../quantity/units.ts";
import type { ShapeReport } from "../../solver/protocol.ts";
import { commitSettings } from "../../state/editing.ts";
import { showNextPanel } from "../../state/selection.ts";
import { Ask } from "../../ui/ask.tsx";
import { LimitField } from "../../ui/limit-field.tsx";
import { stopped } from "../stopping/going-on.ts";
import { gotWords } from "../stopping/way-on.ts";

interface Row {
  /** How the limit begins, see limitHead(). */
  readonly head: string;
  readonly label: string;
  readonly about: string;
  /** What stands between its two numbers, in the limit and for people; none where it has one. */
  readonly mark?: readonly [string, string];
  readonly measure: "degrees" | "length" | "area";
  /** What it is until someone types; `edge` is the mesh's mean edge, `slide` how far a joint slides now. */
  readonly usual: (edge: number, slide: number) => readonly number[];
}

const ROWS: readonly Row[] = [
  {
    head: "fold=",
    label: "Folds up to",
    about: "between neighbouring panels",
    measure: "degrees",
    usual: () => [30],
  },
  {
    head: "fold=+",
    label: "Folds sharper by",
    about: "at most, than before the edit",
    measure: "degrees",
    usual: () => [5],
  },
  {
    head: "angle=",
    label: "Angles",
    about: "of the corners of panels, from and to",
    mark: [":", "–"],
    measure: "degrees",
    usual: () => [45, 135],
  },
  {
    head: "edge=",
    label: "Edges",
    about: "from and to",
    mark: [":", "–"],
    measure: "length",
    usual: (edge) => [niceStep(edge / 2), niceStep(2.5 * edge)],
  },
  {
    head: "area=",
    label: "Area up to",
    about: "of each panel",
    measure: "area",
    usual: (edge) => [niceStep(3 * edge * edge)],
  },
  {
    head: "sheet=",
    label: "Sheet",
    about: "that each panel is cut from",
    mark: ["x", "×"],
    measure: "length",
    usual: (edge) => [niceStep(2.5 * edge), niceStep(2.5 * edge)],
  },
  {
    head: "slide=",
    label: "Joints slide at most",
    about: "along the old surface; handles too",
    measure: "length",
    usual: (edge, slide) => [niceStep((2 * slide) / 3 || edge / 10)],
  },
];

const unitOf = (page: Page, { measure }: Row): string =>
  measure === "degrees" ? "°" : measure === "area" ? `${page.unit.value}²` : page.unit.value;

const stated = (page: Page): readonly string[] => (page.settings.value ?? FIRST_SETTINGS).limits;

const others = (page: Page, head: string): readonly string[] =>
  stated(page).filter((l) => limitHead(l) !== head);

/** `limits` in the order of the rows, so that the same limits are the same design. */
const inOrder = (limits: readonly string[]): readonly string[] =>
  ROWS.flatMap(({ head }) => limits.filter((limit) => limitHead(limit) === head));

/** Numbers of a row, and the limit that stood when they were typed. */
interface Kept {
  readonly numbers: readonly number[];
  readonly beside: string | undefined;
}

function LimitRow({ row }: { row: Row }) {
  const page = usePage();
  const { head, label, about, mark } = row;
  /** Typed while it is off, or refused; of no use once another limit stands, which a drag may have found. */
  const kept = useSignal<Kept | null>(null);
  const refused = useSignal("");
  const on = stated(page).find((limit) => limitHead(limit) === head);
  const edge = page.mesh.value?.report.meanEdge ?? 1;
  const typed = kept.value && kept.value.beside === on ? kept.value.numbers : null;
  const slide = page.figures.value.motion?.slide ?? 0;
  const numbers = typed ?? (on ? limitNumbers(on) : row.usual(edge, slide));

  const state = async (wanted: readonly number[]): Promise<void> => {
    kept.value = { numbers: wanted, beside: on };
    refused.value = "";
    const sorted = head === "sheet=" ? [...wanted].sort((a, b) => a - b) : wanted;
    const limit = head + sorted.join(mark?.[0]);
    const end = await commitSettings(page, { limits: inOrder([...others(page, head), limit]) });
    if (stated(page).includes(limit)) kept.value = null;
    else refused.value = end && !end.ok ? end.reason.replace("bounds: ", "") : "";
  };
  const turnOff = (): void => {
    kept.value = { numbers, beside: undefined };
    refused.value = "";
    void commitSettings(page, { limits: others(page, head) });
  };

  return (
    <div class={mark ? "limit two" : "limit"} title={`${label}: ${about}`}>
      <Check
        label={label}
        checked={on !== undefined}
        disabled={!page.ready.value}
        onChange={(now) => void (now ? state(numbers) : turnOff())}
      />
      {numbers.map((value, k) => (
        <LimitField
          key={k === 0 ? "first" : "second"}
          label={mark ? `${label}, ${k === 0 ? "first" : "second"}` : label}
          about={refused.value || `${unitOf(page, row)}, ${about}`}
          value={value}
          unit={row.measure === "length" ? page.unit.value : null}
          invalid={refused.value !== ""}
          onApply={(given) => void state(numbers.map((x, other) => (other === k ? given : x)))}
        />
      ))}
      {mark && <span class="mark quiet small">{mark[1]}</span>}
      <span class="unit quiet small">{unitOf(page, row)}</span>
      {refused.value && <p class="refused small">{refused.value}</p>}
    </div>
  );
}

const NAMES: Readonly<Record<string, string>> = {
  fold: "folds",
  angle: "angles",
  edge: "edges",
  area: "area",
  sheet: "sheet",
  slide: "slides",
};

/** A slide's are panels with a point at its limit. */
function heldWords(name: string, { length }: readonly number[]): string {
  if (name === "slide") return length === 1 ? "a joint" : `joints of ${length} panels`;
  return length === 1 ? "a panel" : `${length} panels`;
}

/** "asked 25°, is 24.99°"; of the other limits nothing is measured here. */
function foldReached(page: Page, name: string, { sharpestFold }: ShapeReport): string {
  const asked = stated(page).find((limit) => limitHead(limit) === "fold=");
  if (name !== "fold" || !asked || !sharpestFold) return "";
  return ` (asked ${limitNumbers(asked)[0]}°, is ${sharpestFold.after.toFixed(2)}°)`;
}

/** What the limits cost comes before that they hold, but where a drag found its own: the note has it. */
function costWords(page: Page): string {
  const found = stopped(page).value;
  return found && found.reason !== "fold"
    ? `${gotWords(found.stop, page.unit.value)} reached: the`
    : "The";
}

/** What is said where no panel is at its limit: none is in the way, or no way within them was found. */
function freeWords(page: Page): string {
  const found = stopped(page).value;
  if (found?.reason !== "unknown") return "No limit holds this edit back.";
  return `${gotWords(found.stop, page.unit.value)} reached: within the limits no flat panels were found any nearer.`;
}

/** Which limits hold the edit back, and the way to the panels. */
export function LimitStanding() {
  const page = usePage();
  const { bounds, movedVertices } = page.figures.value;
  if (!page.limited.value || !bounds || movedVertices === 0) return null;
  // What keep-outs hold back are points, and said where they are listed.
  const held = Object.entries(bounds).filter(
    ([name, panels]) => name !== "keep-out" && panels.length > 0,
  );
  if (held.length === 0) return <p class="quiet small">{freeWords(page)}</p>;
  return (
    <>
      {held.map(([name, panels], k) => (
        <p key={name} class="small">
          {`${k === 0 ? costWords(page) : "The"} limit on ${NAMES[name] ?? name} holds ${heldWords(name, panels)} back${foldReached(page, name, page.figures.value)}: `}
          <button
            type="button"
            class="text-button"
            title="Go to the next of these panels"
            aria-label={`Show panels at the limit on ${NAMES[name] ?? name}`}
            onClick={() => showNextPanel(page, panels)}
          >
            show
          </button>
        </p>
      ))}
    </>
  );
}

export function Limits() {
  return (
    <>
      <Ask about="limits" />
      {ROWS.map((row) => (
        <LimitRow key={row.head} row={row} />
      ))}
      <p class="quiet small">
        What exceeds a limit already may not get worse, and holds nothing else back.
      </p>
    </>
  );
}

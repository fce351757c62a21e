// SPDX-License-Identifier: MIT
// The small "?" beside a control: what it does, in a sentence and a moving picture.
import { type Signal, useSignal } from "@preact/signals";
import { useLayoutEffect, useRef } from "preact/hooks";
import { HOW_PICTURES, type Subject } from "./how-pictures.ts";
import type { HowLine } from "./how-shapes.ts";
import "./ask.css";

/** Seconds that a moment takes to turn into the next. */
const PACE = 1.6;
/** Pixels. */
const GAP = 8;

const stillPreferred = (): boolean => matchMedia("(prefers-reduced-motion: reduce)").matches;

const written = (moment: HowLine["moments"][number]): string =>
  moment.map((point) => point.map((x) => x.toFixed(1)).join(",")).join(" ");

/** The values there and back. */
const rounds = (values: readonly string[]): string =>
  [...values, ...values.slice(0, -1).reverse()].join(";");

function Animated({ name, values }: { name: string; values: readonly string[] }) {
  if (values.length < 2 || stillPreferred()) return null;
  const spans = 2 * (values.length - 1);
  return (
    <animate
      attributeName={name}
      values={rounds(values)}
      dur={`${PACE * spans}s`}
      calcMode="spline"
      keySplines={Array.from({ length: spans }, () => "0.6 0 0.4 1").join(";")}
      repeatCount="indefinite"
    />
  );
}

/** A line of a picture; without motion its last moment. */
function Line({ look, moments }: HowLine) {
  const last = moments.at(-1) ?? [];
  if (look !== "point")
    return (
      <polyline class={`how-${look}`} points={written(last)}>
        <Animated name="points" values={moments.map(written)} />
      </polyline>
    );
  const along = (axis: 0 | 1): string[] => moments.map((moment) => String(moment[0]?.[axis] ?? 0));
  return (
    <circle class="how-point" r="4" cx={along(0).at(-1)} cy={along(1).at(-1)}>
      <Animated name="cx" values={along(0)} />
      <Animated name="cy" values={along(1)} />
    </circle>
  );
}

/** Left of the inspector where the button is in it, else under the button, or above it where there is more room; inside the window. */
function place(note: HTMLElement, button: HTMLElement): void {
  const [at, own] = [button.getBoundingClientRect(), note.getBoundingClientRect()];
  const within = (wished: number, room: number): number => Math.max(GAP, Math.min(wished, room));
  const left = (button.closest("aside")?.getBoundingClientRect().left ?? 0) - own.width - GAP;
  const under = at.bottom + own.height + GAP < innerHeight || at.top < innerHeight / 2;
  note.style.left = `${within(left > 0 ? left : at.right - own.width, innerWidth - own.width - GAP)}px`;
  const beside = under ? at.bottom + GAP : at.top - own.height - GAP;
  const top = left > 0 ? at.top - GAP : beside;
  note.style.top = `${within(top, innerHeight - own.height - GAP)}px`;
}

/** What there is to choose from where a section has several things to explain. */
function Subjects({ all, chosen }: { all: readonly Subject[]; chosen: Signal<number> }) {
  if (all.length < 2) return null;
  return (
    <div class="how-subjects">
      {all.map((subject, k) => (
        <button
          key={subject}
          type="button"
          aria-pressed={k === chosen.value}
          onClick={() => {
            chosen.value = k;
          }}
        >
          {HOW_PICTURES[subject].name}
        </button>
      ))}
    </div>
  );
}

export function AskButton({ about }: { about: Subject | readonly Subject[] }) {
  const open = useSignal(false);
  const [button, note] = [useRef<HTMLButtonElement>(null), useRef<HTMLDivElement>(null)];
  const all = typeof about === "string" ? [about] : about;
  const chosen = useSignal(0);
  const [name, shown] = [HOW_PICTURES[all[0] ?? "edit"].name, open.value];
  const { words, lines } = HOW_PICTURES[all[chosen.value] ?? "edit"];
  useLayoutEffect(() => {
    if (!shown || !note.current || !button.current) return;
    note.current.showPopover();
    place(note.current, button.current);
  }, [shown]);
  return (
    <>
      <button
        ref={button}
        type="button"
        class="ask"
        aria-label={`What is this? (${name})`}
        aria-expanded={shown}
        onClick={() => {
          open.value = !shown;
        }}
      >
        ?
      </button>
      {shown && (
        <div
          ref={note}
          class="how"
          popover="auto"
          role="note"
          onToggle={({ newState }) => {
            if (newState === "closed") open.value = false;
          }}
        >
          <Subjects all={all} chosen={chosen} />
          <svg key={words} viewBox="0 0 240 96" aria-hidden="true">
            <marker id="how-joint" viewBox="-2 -2 4 4" markerWidth="2.2" markerHeight="2.2">
              <circle r="1.6" />
            </marker>
            {lines.map((line, k) => (
              <Line key={k} {...line} />
            ))}
          </svg>
          <p>{words}</p>
        </div>
      )}
    </>
  );
}

// SPDX-License-Identifier: MIT
// What an edit has to keep to: a chip for each kind of rule, which opens its editor.
import type { ComponentType } from "preact";
import { FIRST_SETTINGS } from "../design/design.ts";
import { formsByPoint } from "../design/listed-supports.ts";
import { areAllOnSurface } from "../design/supports.ts";
import type { EditSettings } from "../solver/protocol.ts";
import { type Rule, shownRule } from "../state/inspector.ts";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import "./rules.css";

interface RuleKind {
  readonly rule: Rule;
  readonly label: string;
  /** How many of them the settings of an edit state. */
  readonly count: (settings: EditSettings) => number;
  readonly Editor: ComponentType;
}

const supported = ({ supports }: EditSettings): number =>
  formsByPoint(supports).size + (areAllOnSurface(supports) ? 1 : 0);

const RULES: readonly RuleKind[] = [
  {
    rule: "limits",
    label: "Limits",
    count: ({ limits }) => limits.length,
    Editor: later(() => import("../features/constraints/limits.tsx").then((part) => part.Limits)),
  },
  {
    rule: "supports",
    label: "Supports",
    count: supported,
    Editor: later(() =>
      import("../features/supports/point-supports.tsx").then((part) => part.PointSupports),
    ),
  },
  {
    rule: "keepOuts",
    label: "Keep-outs",
    count: ({ keepOuts }) => keepOuts.length,
    Editor: later(() =>
      import("../features/keep-outs/keep-outs-section.tsx").then((part) => part.KeepOuts),
    ),
  },
  {
    rule: "symmetry",
    label: "Symmetry",
    count: ({ symmetry }) => symmetry.length,
    Editor: later(() =>
      import("../features/symmetry/symmetry-section.tsx").then((part) => part.SymmetrySection),
    ),
  },
];

const LimitStanding = later(() =>
  import("../features/constraints/limits.tsx").then((part) => part.LimitStanding),
);

function Chip({ rule, label, count }: RuleKind) {
  const page = usePage();
  const shown = shownRule(page);
  const on = count(page.settings.value ?? FIRST_SETTINGS);
  const open = shown.value === rule;
  return (
    <button
      type="button"
      class={on > 0 ? "chip on" : "chip"}
      aria-expanded={open}
      aria-controls={`rule-${rule}`}
      onClick={() => {
        shown.value = open ? null : rule;
      }}
    >
      {on > 0 ? `${label} ${on}` : label}
    </button>
  );
}

export function Rules() {
  const page = usePage();
  const settings = page.settings.value ?? FIRST_SETTINGS;
  const stated = RULES.filter(({ count }) => count(settings) > 0).length;
  const open = shownRule(page).value;
  return (
    <section class="rules" aria-labelledby="rules">
      <h3 id="rules">{stated > 0 ? `Rules (${stated})` : "Rules"}</h3>
      <div class="chips">
        {RULES.map((kind) => (
          <Chip key={kind.rule} {...kind} />
        ))}
      </div>
      {RULES.map(({ rule, label, Editor }) => (
        <section
          key={rule}
          id={`rule-${rule}`}
          class="rule"
          aria-label={label}
          hidden={open !== rule}
        >
          <Editor />
        </section>
      ))}
      <LimitStanding />
    </section>
  );
}

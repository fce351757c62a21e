// SPDX-License-Identifier: MIT
// What an edit has to keep to: a chip for each kind of rule, which opens its editor.
import type { ComponentType } from "preact";
import { useEffect, useRef } from "preact/hooks";
import { FIRST_SETTINGS } from "../design/design.ts";
import { formsByPoint } from "../design/listed-supports.ts";
import { areAllOnSurface } from "../design/supports.ts";
import type { EditSettings } from "../solver/protocol.ts";
import { RULES, type Rule, rulesInOrder, shownRule } from "../state/inspector.ts";
import { later } from "./later.tsx";
import { usePage } from "./page-context.ts";
import { scrollToSection } from "./section-scroll.ts";
import "./rules.css";

interface RuleKind {
  /** How many of them the settings of an edit state. */
  readonly count: (settings: EditSettings) => number;
  readonly Editor: ComponentType;
}

const supported = ({ supports }: EditSettings): number =>
  formsByPoint(supports).size + (areAllOnSurface(supports) ? 1 : 0);

const KINDS: Readonly<Record<Rule, RuleKind>> = {
  limits: {
    count: ({ limits }) => limits.length,
    Editor: later(() => import("../features/constraints/limits.tsx").then((part) => part.Limits)),
  },
  supports: {
    count: supported,
    Editor: later(() =>
      import("../features/supports/point-supports.tsx").then((part) => part.PointSupports),
    ),
  },
  keepOuts: {
    count: ({ keepOuts }) => keepOuts.length,
    Editor: later(() =>
      import("../features/keep-outs/keep-outs-section.tsx").then((part) => part.KeepOuts),
    ),
  },
  symmetry: {
    count: ({ symmetry }) => symmetry.length,
    Editor: later(() =>
      import("../features/symmetry/symmetry-section.tsx").then((part) => part.SymmetrySection),
    ),
  },
};

const LimitStanding = later(() =>
  import("../features/constraints/limits.tsx").then((part) => part.LimitStanding),
);

function Chip({ rule }: { rule: Rule }) {
  const page = usePage();
  const [label, { count }] = [RULES[rule], KINDS[rule]];
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
  const stated = rulesInOrder.filter((rule) => KINDS[rule].count(settings) > 0).length;
  const open = shownRule(page).value;
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    if (open && section.current) scrollToSection(section.current);
  }, [open]);
  return (
    <section ref={section} class="rules" aria-labelledby="rules">
      <h3 id="rules">{stated > 0 ? `Rules (${stated})` : "Rules"}</h3>
      <div class="chips">
        {rulesInOrder.map((rule) => (
          <Chip key={rule} rule={rule} />
        ))}
      </div>
      {rulesInOrder.map((rule) => {
        const { Editor } = KINDS[rule];
        return (
          <section
            key={rule}
            id={`rule-${rule}`}
            class="rule"
            aria-label={RULES[rule]}
            hidden={open !== rule}
          >
            <Editor />
          </section>
        );
      })}
      <LimitStanding />
    </section>
  );
}

// SPDX-License-Identifier: MIT
// What an edit has to keep to: a chip for each kind of rule, which opens its editor.
import { useEffect, useRef } from "preact/hooks";
import { FIRST_SETTINGS } from "../design/design.ts";
import { formsByPoint } from "../design/listed-supports.ts";
import { areAllOnSurface } from "../design/supports.ts";
import type { EditSettings } from "../solver/protocol.ts";
import { RULES, type Rule, rulesInOrder, shownRule } from "../state/inspector.ts";
import { usePage } from "./page-context.ts";
import { EDITORS, RuleNotes } from "./places.ts";
import { scrollToSection } from "./section-scroll.ts";
import "./rules.css";

const supported = ({ supports }: EditSettings): number =>
  formsByPoint(supports).size + (areAllOnSurface(supports) ? 1 : 0);

/** How many of them the settings of an edit state. */
const COUNTS: Readonly<Record<Rule, (settings: EditSettings) => number>> = {
  limits: ({ limits }) => limits.length,
  supports: supported,
  keepOuts: ({ keepOuts }) => keepOuts.length,
  symmetry: ({ symmetry }) => symmetry.length,
};

function Chip({ rule }: { rule: Rule }) {
  const page = usePage();
  const [label, count] = [RULES[rule], COUNTS[rule]];
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
  const stated = rulesInOrder.filter((rule) => COUNTS[rule](settings) > 0).length;
  const open = shownRule(page).value;
  const section = useRef<HTMLElement>(null);
  useEffect(() => {
    if (open && section.current) scrollToSection(section.current);
  }, [open]);
  return (
    <section ref={section} class="rules" aria-labelledby="rules">
      <div class="chips">
        <h3 id="rules">{stated > 0 ? `Rules (${stated})` : "Rules"}</h3>
        {rulesInOrder.map((rule) => (
          <Chip key={rule} rule={rule} />
        ))}
      </div>
      {rulesInOrder.map((rule) => {
        const Editor = EDITORS[rule];
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
      <RuleNotes />
    </section>
  );
}

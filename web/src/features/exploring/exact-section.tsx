// SPDX-License-Identifier: MIT

import { isFlat } from "../../design/flatness.ts";
import type { Page } from "../../state/page.ts";
import { CommandButton } from "../../ui/command-button.tsx";
import { keyOf } from "../../ui/commands/command.ts";
import { COMMANDS } from "../../ui/commands/commands.ts";
import { usePage } from "../../ui/page-context.ts";
import { PanelLists, Verdicts } from "../../ui/places.ts";
import { EXPLORING_COMMANDS } from "./exploring-commands.ts";

function hold(page: Page, on: boolean): void {
  page.showBefore.value = on;
}

/** Project what is shown onto exactly flat panels, and judge the result. */
export function ExactSection() {
  const page = usePage();
  const exact = isFlat(page.figures.value);
  return (
    <section class="step" aria-labelledby="step-exact">
      <h2 id="step-exact" class="visually-hidden">
        Make exact
      </h2>
      <Verdicts />
      <div class="row">
        <CommandButton
          look={exact ? "button grow" : "button grow primary"}
          command={EXPLORING_COMMANDS.makeExact}
        />
        <button
          type="button"
          class="button"
          aria-pressed={page.showBefore.value}
          title={`Hold to see the design before the edit (${keyOf(COMMANDS.before)})`}
          disabled={!page.mesh.value}
          onPointerDown={() => hold(page, true)}
          onPointerUp={() => hold(page, false)}
          onPointerLeave={() => hold(page, false)}
          onKeyDown={(event) => event.key === " " && hold(page, true)}
          onKeyUp={() => hold(page, false)}
        >
          Before
        </button>
      </div>
      <PanelLists />
    </section>
  );
}

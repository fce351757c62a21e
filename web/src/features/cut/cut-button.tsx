// SPDX-License-Identifier: MIT
import { FLAT_FIRST } from "../../state/dragging.ts";
import type { Page } from "../../state/page.ts";
import { type Command, keyOf, notReady, refusalOf } from "../../ui/commands/command.ts";
import { Toggle } from "../../ui/drag-tools.tsx";
import { Icon } from "../../ui/icon.tsx";
import { usePage } from "../../ui/page-context.ts";

export const CUT = {
  label: "Cut panels",
  keys: ["K"],
  heard: "view",
  refusal: (page) => notReady(page) || (page.baseFlat.value ? "" : FLAT_FIRST),
  run: (page: Page) => {
    page.cutting.value = !page.cutting.value;
  },
} satisfies Command;

export function CutTool() {
  const page = usePage();
  const refusal = refusalOf(page, CUT);
  return (
    <Toggle
      kind="cut"
      name={CUT.label}
      word="Cut"
      about={refusal || `clicks part panels, and no point moves (${keyOf(CUT)})`}
      on={page.cutting.value}
      disabled={refusal !== ""}
      onClick={() => CUT.run(page)}
    >
      <Icon name="scissors" />
    </Toggle>
  );
}

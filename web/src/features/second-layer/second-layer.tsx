// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { niceStep, unitWord } from "../../quantity/units.ts";
import type { OffsetChoice } from "../../state/page-state.ts";
import { usePage } from "../../ui/page-context.ts";
import { ChoiceRow, NumberRow, ShopForm } from "../shop/shop-fields.tsx";
import { layOut, offsetWords } from "./offset.ts";

const FORMS = [
  { value: "", text: "What the design allows" },
  { value: "face", text: "Panels at the distance" },
  { value: "vertex", text: "Points at the distance" },
  { value: "parallel", text: "Parallel edges only" },
] as const;

/** The design at a distance: a glazing layer, a lower chord, the other side of a thick panel. */
export function SecondLayer() {
  const page = usePage();
  const usual = niceStep((page.mesh.value?.report.meanEdge ?? 1) / 5);
  const distance = useSignal("");
  const form = useSignal<OffsetChoice["form"]>(page.offsetChoice.peek()?.form ?? "");
  const said = useSignal<string | null>(null);
  const show = async (): Promise<void> => {
    const choice = { distance: Number(distance.value || usual), form: form.value };
    const laid = await layOut(page, choice);
    const layer = page.offsetLayer.value;
    const refusal = laid && !laid.ok ? laid.reason : null;
    said.value = layer ? offsetWords(page, layer, choice.distance) : refusal;
  };
  return (
    <ShopForm save="Show" onSave={show} said={said.value}>
      <NumberRow
        label={`Distance, ${unitWord(page.unit.value)}`}
        value={distance}
        otherwise={String(usual)}
        min=""
      />
      <ChoiceRow label="Offset kind" value={form} choices={FORMS} />
      <p class="quiet">
        A second layer whose edges are parallel to those of the design, outside of it, or inside
        with a distance below 0. It stays in the view and follows the design; GLB files hold it too.
      </p>
    </ShopForm>
  );
}

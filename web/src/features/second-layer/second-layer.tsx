// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { useEffect, useRef } from "preact/hooks";
import type { Design } from "../../design/design.ts";
import { niceStep, unitWord } from "../../quantity/units.ts";
import { layerCalls } from "../../state/inspector.ts";
import type { OffsetChoice } from "../../state/page-state.ts";
import { usePage } from "../../ui/page-context.ts";
import { scrollToSection } from "../../ui/section-scroll.ts";
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
  const distance = useSignal(String(page.offsetChoice.peek()?.distance ?? ""));
  const form = useSignal<OffsetChoice["form"]>(page.offsetChoice.peek()?.form ?? "");
  const refused = useSignal<{ readonly of: Design | undefined; readonly why: string } | null>(null);
  const [design, laid, layer] = [
    page.history.value?.present,
    page.offsetChoice.value,
    page.offsetLayer.value,
  ];
  const show = async (): Promise<void> => {
    const choice = { distance: Number(distance.value || usual), form: form.value };
    const of = page.history.peek()?.present;
    const answer = await layOut(page, choice);
    refused.value = answer && !answer.ok ? { of, why: answer.reason } : null;
  };
  const refusal = refused.value?.of === design ? (refused.value?.why ?? null) : null;
  const said = laid && layer ? offsetWords(page, layer, laid.distance) : refusal;
  const whole = useRef<HTMLDivElement>(null);
  const calls = layerCalls(page).value;
  useEffect(() => {
    if (whole.current) scrollToSection(whole.current);
  }, [calls]);
  return (
    <div ref={whole}>
      <ShopForm save="Show" onSave={show} said={said}>
        <NumberRow
          label={`Distance, ${unitWord(page.unit.value)}`}
          value={distance}
          otherwise={String(usual)}
          min=""
        />
        <ChoiceRow label="Offset kind" value={form} choices={FORMS} />
        <p class="quiet">
          A second layer whose edges are parallel to those of the design, outside of it, or inside
          with a distance below 0. It stays in the view and follows the design; GLB files hold it
          too.
        </p>
      </ShopForm>
    </div>
  );
}

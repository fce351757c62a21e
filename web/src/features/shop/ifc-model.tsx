// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import type { Unit } from "../../quantity/units.ts";
import { WITHOUT_TYPES } from "../../solver/cutting-options.ts";
import type { CuttingHeader } from "../../solver/protocol.ts";
import { usePage } from "../../ui/page-context.ts";
import { exportIfc, type Scope } from "./shop.ts";
import { NumberRow, ScopeRow, ShopForm, UnitRow } from "./shop-fields.tsx";
import { summary } from "./shop-summary.ts";

/** The design as a curtain wall of plates. */
export function IfcModel() {
  const page = usePage();
  const [gap, thickness] = [useSignal(""), useSignal("")];
  const modelUnit = useSignal<Unit>("mm");
  const scope = useSignal<Scope>("all");
  const header = useSignal<CuttingHeader | null>(null);
  const save = async (): Promise<void> => {
    header.value = null;
    header.value = await exportIfc(page, {
      unit: modelUnit.value,
      scope: scope.value,
      gap: Number(gap.value),
      thickness: Number(thickness.value),
      sheetWidth: 0,
      sheetHeight: 0,
      textHeight: 0,
      ...WITHOUT_TYPES,
    });
  };
  return (
    <ShopForm save="Save IFC" onSave={save} said={header.value && summary(header.value)}>
      <UnitRow label="Unit of the model" value={modelUnit} />
      <ScopeRow label="Plates of" value={scope} />
      <NumberRow label="Joint between panels" value={gap} />
      <NumberRow label="Thickness" value={thickness} />
      <p class="quiet">
        A curtain wall with one plate a panel, flat as it is or solid to the inside, with its area,
        flatness and what must be made again. Its identifiers stay when this design is edited and
        saved again.
      </p>
    </ShopForm>
  );
}

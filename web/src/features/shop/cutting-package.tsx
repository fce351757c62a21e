// SPDX-License-Identifier: MIT

import { useComputed, useSignal } from "@preact/signals";
import { useEffect } from "preact/hooks";
import { type Unit, unitWord } from "../../quantity/units.ts";
import { usePage } from "../../ui/page-context.ts";
import { CuttingPreview, type Saved, usePreview } from "./cutting-preview.tsx";
import { previewPackage } from "./package-preview.ts";
import { exportPackage, hasCode, type PackageChoice, type Scope } from "./shop.ts";
import { ChoiceRow, NumberRow, ScopeRow, ShopForm, SwitchRow, UnitRow } from "./shop-fields.tsx";

type Cut = "panel" | "type";

const CUTS = [
  { value: "panel", text: "Each panel by itself" },
  { value: "type", text: "One template a type" },
] as const;

const NO_TOLERANCE = "one drawing a type needs to know by how much joints may vary";

/** The rule of the core that can be told without it; it has the others, which come with the preview. */
const missing = ({ byType, jointBy }: PackageChoice): string =>
  byType && !(jointBy > 0) ? NO_TOLERANCE : "";

/** Said before the package is saved: until then the design stays as it is. */
function TooLong() {
  const page = usePage();
  const fits = useSignal(true);
  useEffect(() => {
    void hasCode(page).then((has) => {
      fits.value = has;
    });
  }, [page]);
  if (fits.value) return null;
  return (
    <p class="quiet">The link of this design is too long for a code: the labels will carry none.</p>
  );
}

/** Asks what the workshop needs, and saves it. */
export function CuttingPackage() {
  const page = usePage();
  const [gap, thickness, text] = [useSignal(""), useSignal(""), useSignal("")];
  const [width, height] = [useSignal(""), useSignal("")];
  const packageUnit = useSignal<Unit>("mm");
  const scope = useSignal<Scope>("all");
  const [cut, jointBy, mirrored] = [useSignal<Cut>("panel"), useSignal(""), useSignal(false)];
  const withLink = useSignal(true);
  const saved = useSignal<Saved | null>(null);
  const choice = useComputed(
    (): PackageChoice => ({
      unit: packageUnit.value,
      scope: scope.value,
      gap: Number(gap.value),
      thickness: Number(thickness.value),
      sheetWidth: Number(width.value),
      sheetHeight: Number(height.value),
      textHeight: Number(text.value),
      jointBy: cut.value === "type" ? Number(jointBy.value) : 0,
      mirrored: mirrored.value,
      byType: cut.value === "type",
      withLink: withLink.value,
    }),
  );
  const previewed = usePreview(choice);
  const refused = useSignal<{ readonly problem: string; readonly of: PackageChoice } | null>(null);
  const save = async (): Promise<void> => {
    const of = choice.value;
    // Saved sooner than the preview came: what is wrong is said here all the same.
    const known = previewed.shown?.of === of;
    const problem = known ? "" : (await previewPackage(page, of, false))?.problem;
    if (problem) {
      refused.value = { problem, of };
      return;
    }
    const header = await exportPackage(page, of);
    saved.value = header && { header, of };
  };
  const done = saved.value?.of === choice.value ? saved.value.header : null;
  const said = refused.value?.of === choice.value ? refused.value.problem : "";
  const foreseen = said || (previewed.shown?.preview.problem ?? "");
  const problem = missing(choice.value) || (done ? "" : foreseen);
  return (
    <ShopForm save="Save package" onSave={save} said={null} refused={problem}>
      <UnitRow label="Unit of the drawings" value={packageUnit} />
      <ScopeRow label="Drawings of" value={scope} />
      <NumberRow label="Joint between panels" value={gap} />
      <ChoiceRow label="Drawn" value={cut} choices={CUTS} />
      {cut.value === "type" && (
        <>
          <NumberRow label="Joints vary by up to" value={jointBy} otherwise="needed" />
          <SwitchRow label="Panels may be turned over" value={mirrored} />
        </>
      )}
      <NumberRow label="Thickness" value={thickness} />
      <NumberRow label="Sheet width" value={width} />
      <NumberRow label="Sheet height" value={height} />
      <NumberRow label="Text height" value={text} otherwise="by panel" />
      <SwitchRow label="Labels with a QR code" value={withLink} />
      {withLink.value && <TooLong />}
      <p class="quiet">
        {`Tables, one DXF of all panels and one of each, a map, labels to print, and with a sheet size the panels arranged on sheets (in rows, not nested). The code is the link that opens this design and verifies it. The model is in ${unitWord(page.unit.value)}; panels are seen from outside.`}
      </p>
      <CuttingPreview previewed={previewed} done={done} problem={problem} />
    </ShopForm>
  );
}

// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { type Unit, unitWord } from "../../quantity/units.ts";
import { usePage } from "../../ui/page-context.ts";
import { exportDrawings } from "./shop.ts";
import { ChoiceRow, NumberRow, ShopForm, TextRow, UnitRow } from "./shop-fields.tsx";

type Across = "none" | "x" | "y" | "z";

const ACROSS = [
  { value: "none", text: "None" },
  { value: "x", text: "Across x, seen from the right" },
  { value: "y", text: "Across y, seen from the front" },
  { value: "z", text: "Level, seen from above" },
] as const;

/** As the command line has them: a, b, c, d of a·x + b·y + c·z = d. */
function planeOf(across: Across, at: number): readonly number[] {
  if (across === "none") return [];
  if (across === "y") return [0, -1, 0, -at];
  return [across === "x" ? 1 : 0, 0, across === "z" ? 1 : 0, at];
}

/** "x=4.5:A, z=3.2:Eaves" one by one. */
const axesOf = (text: string): readonly string[] =>
  text
    .split(",")
    .map((axis) => axis.trim())
    .filter((axis) => axis !== "");

/** Plan, elevations and a section, to scale. */
export function StructureDrawings() {
  const page = usePage();
  const [scale, at, axes] = [useSignal(""), useSignal(""), useSignal("")];
  const drawingUnit = useSignal<Unit>("mm");
  const across = useSignal<Across>("none");
  const said = useSignal<string | null>(null);
  const save = async (): Promise<void> => {
    said.value = null;
    const sections = planeOf(across.value, Number(at.value));
    const options = {
      unit: drawingUnit.value,
      scale: Number(scale.value),
      sections,
      axes: axesOf(axes.value),
    };
    const drawn = await exportDrawings(page, options);
    if (drawn === null) return;
    const missed = drawn.missed.length > 0 ? " The section does not meet the structure." : "";
    said.value = `Drawn at 1 : ${drawn.scale}.${missed}`;
  };
  return (
    <ShopForm save="Save drawings" onSave={save} said={said.value}>
      <UnitRow label="Unit of the DXF" value={drawingUnit} />
      <NumberRow label="Scale 1 :" value={scale} otherwise="fits A3" />
      <ChoiceRow label="Section" value={across} choices={ACROSS} />
      {across.value !== "none" && (
        <NumberRow
          label={`Section at ${across.value}, ${unitWord(page.unit.value)}`}
          value={at}
          otherwise="0"
          min=""
        />
      )}
      <TextRow label="Axes and levels" value={axes} placeholder="x=4.5:A, z=3.2:Eaves" />
      <p class="quiet">
        Plan, four elevations and the section, each as SVG to scale and as DXF at full size, with
        sizes, and the levels of the lowest and the highest point. The front is at the lowest y.
      </p>
    </ShopForm>
  );
}

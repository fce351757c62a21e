// SPDX-License-Identifier: MIT
import "./cutting-package.css";
import { type Signal, useComputed, useSignal } from "@preact/signals";
import { exportPackage, type PackageChoice } from "../export/cutting-package.ts";
import { busy, unit } from "../state/store.ts";
import { UNITS, type Unit, unitWord } from "../state/units.ts";
import { CuttingPreview, type Saved } from "./cutting-preview.tsx";

interface Field {
  readonly label: string;
  readonly value: Signal<string>;
}

/** A length, 0 or empty for none. */
function Length({ label, value }: Field) {
  return (
    <>
      <label for={`package-${label}`}>{label}</label>
      <input
        id={`package-${label}`}
        type="number"
        min="0"
        step="any"
        placeholder="none"
        value={value.value}
        onInput={({ currentTarget }) => {
          value.value = currentTarget.value;
        }}
      />
    </>
  );
}

/** Asks what the workshop needs, and saves it. */
export function CuttingPackage() {
  const [gap, thickness, width, height] = [
    useSignal(""),
    useSignal(""),
    useSignal(""),
    useSignal(""),
  ];
  const packageUnit = useSignal<Unit>("mm");
  const remakeOnly = useSignal(false);
  const saved = useSignal<Saved | null>(null);
  const choice = useComputed(
    (): PackageChoice => ({
      unit: packageUnit.value,
      gap: Number(gap.value),
      thickness: Number(thickness.value),
      sheetWidth: Number(width.value),
      sheetHeight: Number(height.value),
      remakeOnly: remakeOnly.value,
    }),
  );
  const write = async (): Promise<void> => {
    const of = choice.value;
    const header = await exportPackage(of);
    saved.value = header && { header, of };
  };
  return (
    <form
      class="cutting-package"
      onSubmit={(event) => {
        event.preventDefault();
        void write();
      }}
    >
      <label for="package-unit">Unit of the drawings</label>
      <select
        id="package-unit"
        class="select"
        value={packageUnit.value}
        onChange={({ currentTarget }) => {
          packageUnit.value = UNITS.find((word) => word === currentTarget.value) ?? "mm";
        }}
      >
        {UNITS.map((word) => (
          <option key={word} value={word}>
            {unitWord(word)}
          </option>
        ))}
      </select>
      <label for="package-scope">Drawings of</label>
      <select
        id="package-scope"
        class="select"
        value={remakeOnly.value ? "remake" : "all"}
        onChange={({ currentTarget }) => {
          remakeOnly.value = currentTarget.value === "remake";
        }}
      >
        <option value="all">All panels</option>
        <option value="remake">What must be made again</option>
      </select>
      <Length label="Joint between panels" value={gap} />
      <Length label="Thickness" value={thickness} />
      <Length label="Sheet width" value={width} />
      <Length label="Sheet height" value={height} />
      <p class="quiet">
        {`Tables, one DXF of all panels and one of each, a map, and with a sheet size the panels arranged on sheets (in rows, not nested). The model is in ${unitWord(unit.value)}; panels are seen from outside.`}
      </p>
      <CuttingPreview choice={choice} saved={saved} />
      <div class="dialog-actions">
        <button type="submit" class="button" disabled={busy.value}>
          Save package
        </button>
      </div>
    </form>
  );
}

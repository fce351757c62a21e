// SPDX-License-Identifier: MIT
import "./cutting-package.css";
import { type Signal, useSignal } from "@preact/signals";
import { exportPackage } from "../export/cutting-package.ts";
import type { CuttingHeader } from "../solver/protocol.ts";
import { busy, unit } from "../state/store.ts";
import { UNITS, type Unit, unitWord } from "../state/units.ts";

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

const panels = (count: number): string => `${count} ${count === 1 ? "panel" : "panels"}`;

/** What the package holds, in words. */
function summary({ counts, remake, sheets, vanished, flatness_mm_per_m }: CuttingHeader): string {
  const parts = [`${panels(counts.drawn)} drawn`];
  if (remake)
    parts.push(`${remake.outline} to be cut again, ${remake.bevel} with a new bevel only`);
  if (sheets) {
    const used = Math.round(100 * sheets.used_fraction);
    parts.push(`${sheets.count} ${sheets.count === 1 ? "sheet" : "sheets"}, ${used} % used`);
    if (sheets.oversize.length > 0)
      parts.push(`${panels(sheets.oversize.length)} larger than a sheet`);
  }
  if (vanished.length > 0)
    parts.push(
      `not drawn, as nothing is left of them or they cross themselves: ${vanished.join(", ")}`,
    );
  if (flatness_mm_per_m > 1e-3)
    parts.push(`not flat: a panel is out of its plane by ${flatness_mm_per_m.toPrecision(2)} mm/m`);
  return `${parts.join("; ")}.`;
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
  const header = useSignal<CuttingHeader | null>(null);
  const write = async (): Promise<void> => {
    header.value = null;
    header.value = await exportPackage({
      unit: packageUnit.value,
      gap: Number(gap.value),
      thickness: Number(thickness.value),
      sheetWidth: Number(width.value),
      sheetHeight: Number(height.value),
      remakeOnly: remakeOnly.value,
    });
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
      <div class="dialog-actions">
        <span aria-live="polite">{header.value && summary(header.value)}</span>
        <button type="submit" class="button" disabled={busy.value}>
          Save package
        </button>
      </div>
    </form>
  );
}

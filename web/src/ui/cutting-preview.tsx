// SPDX-License-Identifier: MIT
import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { PackageChoice } from "../export/cutting-package.ts";
import { headerOf, previewPackage } from "../export/cutting-preview.ts";
import type { CuttingHeader, CuttingPreview as Preview } from "../solver/protocol.ts";
import type { Design } from "../state/design.ts";
import { history, unit } from "../state/store.ts";

/** What a saved package held, and for which choice. */
export interface Saved {
  readonly header: CuttingHeader;
  readonly of: PackageChoice;
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

/** Names are not to be read at this size, and take long to draw. */
const withoutTexts = (svg: string): string => svg.replace(/<text[^>]*>[^<]*<\/text>/g, "");

function Picture({ svg, about }: { svg: string; about: string }) {
  const address = useSignal("");
  useEffect(() => {
    const made = URL.createObjectURL(new Blob([svg], { type: "image/svg+xml" }));
    address.value = made;
    return () => URL.revokeObjectURL(made);
  }, [svg]);
  return (
    <figure>
      {address.value && <img src={address.value} alt="" decoding="async" />}
      <figcaption>{about}</figcaption>
    </figure>
  );
}

interface Shown {
  readonly preview: Preview;
  readonly of: PackageChoice;
}

/** While somebody types. */
const PAUSE_MS = 150;

/** Follows the options and the design. */
function usePreview(choice: ReadonlySignal<PackageChoice>) {
  const shown = useSignal<Shown | null>(null);
  const map = useSignal<{ readonly svg: string; readonly of: Design | null } | null>(null);
  useSignalEffect(() => {
    const [of, design] = [choice.value, history.value?.present ?? null];
    unit.value; // asked for with the options
    const ask = async (): Promise<void> => {
      const wanted = map.peek()?.of !== design;
      const preview = await previewPackage(of, wanted);
      if (!preview) return;
      if (preview.map) map.value = { svg: withoutTexts(preview.map), of: design };
      shown.value = { preview, of };
    };
    const timer = setTimeout(() => void ask(), PAUSE_MS);
    return () => clearTimeout(timer);
  });
  return { shown: shown.value, map: map.value };
}

interface CuttingPreviewProps {
  readonly choice: ReadonlySignal<PackageChoice>;
  readonly saved: ReadonlySignal<Saved | null>;
}

/** What the package would hold, or held when it was saved like this: figures, the map, one panel. */
export function CuttingPreview({ choice, saved }: CuttingPreviewProps) {
  const { shown, map } = usePreview(choice);
  const done = saved.value?.of === choice.value ? saved.value.header : null;
  const problem = done ? "" : (shown?.preview.problem ?? "");
  const words = done
    ? `Saved: ${summary(done)}`
    : shown && !problem && summary(headerOf(shown.preview, shown.of));
  return (
    <>
      <div class="cutting-pictures">
        {map && (
          <Picture svg={map.svg} about="Map: orange is cut again, blue has a new bevel only" />
        )}
        {shown?.preview.drawing && (
          <Picture svg={shown.preview.drawing} about={`${shown.preview.shown}, as it is drawn`} />
        )}
      </div>
      <p class="cutting-summary" aria-live="polite">
        {problem ? `Not like this: ${problem}.` : words}
      </p>
    </>
  );
}

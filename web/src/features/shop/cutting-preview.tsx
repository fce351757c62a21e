// SPDX-License-Identifier: MIT

import { type ReadonlySignal, useSignal, useSignalEffect } from "@preact/signals";
import { useEffect } from "preact/hooks";
import type { Design } from "../../design/design.ts";
import type { CuttingHeader, CuttingPreview as Preview } from "../../solver/protocol.ts";
import { usePage } from "../../ui/page-context.ts";
import { headerOf, previewPackage } from "./package-preview.ts";
import type { PackageChoice } from "./shop.ts";
import { summary } from "./shop-summary.ts";

/** What a saved package held, and for which choice. */
export interface Saved {
  readonly header: CuttingHeader;
  readonly of: PackageChoice;
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

/** Milliseconds to wait while somebody types. */
const PAUSE_MS = 150;

/** Follows the options and the design. */
export function usePreview(choice: ReadonlySignal<PackageChoice>) {
  const page = usePage();
  const shown = useSignal<Shown | null>(null);
  const map = useSignal<{ readonly svg: string; readonly of: Design | null } | null>(null);
  useSignalEffect(() => {
    const [of, design] = [choice.value, page.history.value?.present ?? null];
    page.unit.value; // asked for with the options
    const ask = async (): Promise<void> => {
      const wanted = map.peek()?.of !== design;
      const preview = await previewPackage(page, of, wanted);
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
  readonly previewed: ReturnType<typeof usePreview>;
  /** What the package held, where one was saved like this. */
  readonly done: CuttingHeader | null;
  /** Why there can be none like this; "" where there can. */
  readonly problem: string;
}

/** What the package would hold, or held when it was saved like this: figures, the map, one panel. */
export function CuttingPreview({ previewed, done, problem }: CuttingPreviewProps) {
  const { shown, map } = previewed;
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
      <p class={problem ? "cutting-summary refused" : "cutting-summary"} aria-live="polite">
        {problem ? `Not like this: ${problem}.` : words}
      </p>
    </>
  );
}

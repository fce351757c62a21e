// SPDX-License-Identifier: MIT
import { useSignal } from "@preact/signals";
import { useRef } from "preact/hooks";
import { exportMesh } from "../export/exporting.ts";
import { readCamera } from "../state/camera.ts";
import { fetchPart } from "../state/later.ts";
import { recipeOf } from "../state/recipe.ts";
import { draft, ready, unit } from "../state/store.ts";
import { Dialog } from "./dialog.tsx";
import { Icon } from "./icon.tsx";

/** Mail programs and chats start to cut links about here. */
const LONG = 8_000;
/** Longer links are better sent as a file. */
const TOO_LONG = 32_000;

interface Shared {
  readonly link: string;
  readonly copied: boolean;
}

function advice({ link, copied }: Shared): string {
  const what = `${copied ? "Copied" : "Copy this link"}: ${link.length} characters.`;
  if (link.length > TOO_LONG)
    return `${what} That is too long for most programs: send the design as a file instead.`;
  if (link.length > LONG) return `${what} Some programs cut links this long.`;
  return `${what} It holds the whole design; nothing is stored anywhere else.`;
}

async function share(): Promise<Shared | null> {
  const links = await fetchPart(() => import("../share/link.ts"));
  const design = draft.value;
  if (!links || !design) return null;
  const url = new URL(location.href);
  url.hash = "";
  const link = url.href + (await links.encodeLink(recipeOf(design, unit.value, readCamera())));
  const copied = await navigator.clipboard.writeText(link).then(
    () => true,
    () => false,
  );
  return { link, copied };
}

export function ShareDialog() {
  const dialog = useRef<HTMLDialogElement>(null);
  const shared = useSignal<Shared | null>(null);
  const open = async (): Promise<void> => {
    shared.value = await share();
    if (shared.value) dialog.current?.showModal();
  };
  return (
    <>
      <button
        type="button"
        class="bar-button"
        title="Share"
        disabled={!ready.value}
        onClick={() => void open()}
      >
        <Icon name="share" />
        <span class="bar-label">Share</span>
      </button>
      <Dialog dialog={dialog} id="share" title="Share this design">
        {shared.value && (
          <>
            <input
              type="text"
              class="link-box"
              readOnly
              aria-label="Link"
              value={shared.value.link}
              onFocus={({ currentTarget }) => currentTarget.select()}
            />
            <p>{advice(shared.value)}</p>
            {shared.value.link.length > TOO_LONG && (
              <div class="dialog-actions">
                <button
                  type="button"
                  class="button primary"
                  onClick={() => {
                    dialog.current?.close();
                    void exportMesh("glb");
                  }}
                >
                  Save as GLB
                </button>
              </div>
            )}
          </>
        )}
      </Dialog>
    </>
  );
}

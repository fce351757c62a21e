// SPDX-License-Identifier: MIT

import { designLink } from "../export/design-link.ts";
import { exportMesh } from "../export/exporting.ts";
import { readCamera } from "../state/camera.ts";
import type { Page } from "../state/page.ts";
import { inTurn } from "../state/turns.ts";
import { usePage } from "./page-context.ts";

/** Mail programs and chats start to cut links about here. */
const LONG = 8_000;
/** Longer links are better sent as a file. */
const TOO_LONG = 32_000;

export interface Shared {
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

/** Makes the link of the design, once all that was asked for is done, and copies it, where the
 * browser lets it. */
export async function share(page: Page): Promise<Shared | null> {
  const link = await inTurn(page, () => designLink(page, readCamera(page)));
  return link?.ok ? copy(link.value) : null;
}

async function copy(link: string): Promise<Shared> {
  const copied = await navigator.clipboard.writeText(link).then(
    () => true,
    () => false,
  );
  return { link, copied };
}

interface SharedLinkProps {
  readonly shared: Shared;
  readonly onClose: () => void;
}

export function SharedLink({ shared, onClose }: SharedLinkProps) {
  const page = usePage();
  return (
    <>
      <input
        type="text"
        class="link-box"
        readOnly
        aria-label="Link"
        value={shared.link}
        onFocus={({ currentTarget }) => currentTarget.select()}
      />
      <p>{advice(shared)}</p>
      {shared.link.length > TOO_LONG && (
        <div class="dialog-actions">
          <button
            type="button"
            class="button primary"
            onClick={() => {
              onClose();
              void exportMesh(page, "glb");
            }}
          >
            Save as GLB
          </button>
        </div>
      )}
    </>
  );
}

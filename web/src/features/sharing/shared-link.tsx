// SPDX-License-Identifier: MIT

import { useSignal } from "@preact/signals";
import { Check } from "../../ui/check.tsx";
import "./going-along.css";
import { EVERYTHING, snapshotsToSend, type Taken } from "../../export/companions.ts";
import { designLink } from "../../export/design-link.ts";
import { exportDesign } from "../../export/exporting.ts";
import { counted } from "../../quantity/counted.ts";
import { enqueue } from "../../state/action-queue.ts";
import { readCamera } from "../../state/camera.ts";
import { groups } from "../../state/groups.ts";
import { note } from "../../state/note.ts";
import type { Page } from "../../state/page.ts";
import { usePage } from "../../ui/page-context.ts";

/** Mail programs and chats start to cut links about here. */
const LONG = 8_000;
/** Longer links are better sent as a file. */
const TOO_LONG = 32_000;

export interface Shared {
  readonly link: string;
  readonly copied: boolean;
  readonly taken: Taken;
}

function advice({ link, copied }: Shared): string {
  const what = `${copied ? "Copied" : "Copy this link"}: ${link.length} characters.`;
  if (link.length > TOO_LONG)
    return `${what} That is too long for most programs: save the design and send the file; it holds all that a link does.`;
  if (link.length > LONG)
    return `${what} Some programs cut links this long: a saved design holds all that it does.`;
  return `${what} It holds the whole design; nothing is stored anywhere else.`;
}

/** Makes the link of the design, once all that was asked for is done, and copies it, where the
 * browser lets it. */
export async function share(page: Page, taken = EVERYTHING): Promise<Shared | null> {
  const link = await enqueue(page, () => designLink(page, readCamera(page), taken));
  return link?.ok ? { ...(await copy(link.value)), taken } : null;
}

async function copy(link: string): Promise<Omit<Shared, "taken">> {
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

/** What there is to go along, by its words. */
function companionsHere(page: Page): readonly (readonly [keyof Taken, string])[] {
  const [views, snapshots] = [page.views.value.length, snapshotsToSend(page).length];
  const sets = groups(page).value.length;
  return [
    ...(note(page).value.trim() ? [["note", "Note"] as const] : []),
    ...(views > 0 ? [["views", counted(views, "named view")] as const] : []),
    ...(snapshots > 0 ? [["snapshots", counted(snapshots, "snapshot")] as const] : []),
    ...(sets > 0 ? [["groups", counted(sets, "group")] as const] : []),
  ];
}

interface GoingAlongProps {
  readonly taken: Taken;
  readonly onChange: (taken: Taken) => void;
}

function GoingAlong({ taken, onChange }: GoingAlongProps) {
  const page = usePage();
  const here = companionsHere(page);
  const left = page.snapshots.value.length - snapshotsToSend(page).length;
  return (
    <>
      {here.length > 0 && (
        <fieldset class="going-along">
          <legend>Goes along, beside the view that you have now</legend>
          {here.map(([key, words]) => (
            <Check
              key={key}
              label={words}
              checked={taken[key]}
              onChange={(on) => onChange({ ...taken, [key]: on })}
            />
          ))}
        </fieldset>
      )}
      {left > 0 && (
        <p class="quiet small">{`${counted(left, "snapshot")} of another mesh, or too many, stay here.`}</p>
      )}
    </>
  );
}

export function SharedLink({ shared: first, onClose }: SharedLinkProps) {
  const page = usePage();
  const shown = useSignal(first);
  const shared = shown.value;
  const change = async (taken: Taken): Promise<void> => {
    const next = await share(page, taken);
    if (next) shown.value = next;
  };
  return (
    <>
      <GoingAlong taken={shared.taken} onChange={(taken) => void change(taken)} />
      <input
        type="text"
        class="link-box"
        readOnly
        aria-label="Link"
        value={shared.link}
        onFocus={({ currentTarget }) => currentTarget.select()}
      />
      <p>{advice(shared)}</p>
      {!shared.copied && (
        <button
          type="button"
          class="button"
          onClick={({ currentTarget }) => {
            const box = currentTarget.parentElement?.querySelector<HTMLInputElement>(".link-box");
            box?.select();
            // The older way asks for no permission.
            if (document.execCommand("copy")) shown.value = { ...shared, copied: true };
          }}
        >
          Copy
        </button>
      )}
      {shared.link.length > LONG && (
        <div class="dialog-actions">
          <button
            type="button"
            class={shared.link.length > TOO_LONG ? "button primary" : "button"}
            onClick={() => {
              onClose();
              void exportDesign(page);
            }}
          >
            Save design
          </button>
        </div>
      )}
    </>
  );
}

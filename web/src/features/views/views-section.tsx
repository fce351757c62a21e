// SPDX-License-Identifier: MIT
// Views kept under a name: to look from there again, to rename and to delete.
import type { NamedView } from "../../design/camera.ts";
import { Ask } from "../../ui/ask.tsx";
import { CommandButton } from "../../ui/command-button.tsx";
import { DeleteButton, NameField } from "../../ui/name-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import { deleteView, KEEP_VIEW, renameView, showView } from "./named-views.ts";

function Row({ view }: { view: NamedView }) {
  const page = usePage();
  const { name } = view;
  return (
    <li class="named-view">
      <NameField name={name} onRename={(to) => renameView(page, view, to)} />
      <button
        type="button"
        class="button small"
        aria-label={`Show ${name}`}
        onClick={() => showView(page, view)}
      >
        Show
      </button>
      <DeleteButton name={name} onDelete={() => deleteView(page, view)} />
    </li>
  );
}

export function ViewsSection() {
  const page = usePage();
  return (
    <section class="step" aria-labelledby="named-views">
      <h2 id="named-views">Named views</h2>
      <Ask about="views" />
      <CommandButton look="button wide" command={KEEP_VIEW} />
      {page.views.value.length > 0 && (
        <ul class="snapshots" aria-labelledby="named-views">
          {page.views.value.map((view, k) => (
            <Row key={k} view={view} />
          ))}
        </ul>
      )}
    </section>
  );
}

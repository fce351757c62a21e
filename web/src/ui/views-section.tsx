// SPDX-License-Identifier: MIT
// Views kept under a name: to look from there again, to rename and to delete.
import type { NamedView } from "../design/camera.ts";
import { deleteView, renameView, showView } from "../state/named-views.ts";
import { Ask } from "./ask.tsx";
import { CommandButton } from "./command-button.tsx";
import { KEEP_VIEW } from "./commands/view-commands.ts";
import { DeleteButton, NameField } from "./name-field.tsx";
import { usePage } from "./page-context.ts";

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

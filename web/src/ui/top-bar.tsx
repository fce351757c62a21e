// SPDX-License-Identifier: MIT
import { redo, undo } from "../state/editing.ts";
import { offeredFigures, openFigure, shownFigure } from "../state/figures.ts";
import { openSample } from "../state/opening.ts";
import { SAMPLES } from "../state/samples.ts";
import { canRedo, canUndo, designName, history, ready } from "../state/store.ts";
import { ExportMenu } from "./export-menu.tsx";
import { HelpDialog } from "./help-dialog.tsx";
import { Icon, type IconName } from "./icon.tsx";
import { pickAndOpen } from "./pick-file.ts";
import { ShareDialog } from "./share-dialog.tsx";

interface BarButtonProps {
  readonly icon: IconName;
  readonly label: string;
  readonly keys?: string;
  readonly disabled: boolean;
  readonly onClick: () => void;
}

function BarButton({ icon, label, keys, disabled, onClick }: BarButtonProps) {
  return (
    <button
      type="button"
      class="bar-button"
      disabled={disabled}
      onClick={onClick}
      title={keys ? `${label} (${keys})` : label}
    >
      <Icon name={icon} />
      <span class="bar-label">{label}</span>
    </button>
  );
}

function SampleChooser() {
  const source = history.value?.present.source;
  const value = shownFigure.value?.name ?? (source?.kind === "sample" ? source.name : "");
  return (
    <select
      aria-label="Sample"
      class="select"
      disabled={!ready.value}
      value={value}
      onChange={({ currentTarget }) => {
        if (!openFigure(currentTarget.value)) void openSample(currentTarget.value);
      }}
    >
      {value === "" && (
        <option value="" disabled>
          {designName.value}
        </option>
      )}
      {SAMPLES.map((sample) => (
        <option key={sample.name} value={sample.name}>
          {sample.label}
        </option>
      ))}
      <optgroup label="Figures of the paper">
        {offeredFigures.value.map((figure) => (
          <option key={figure.name} value={figure.name}>
            {figure.label}
          </option>
        ))}
      </optgroup>
    </select>
  );
}

export function TopBar() {
  return (
    <header class="top-bar">
      <h1 class="brand">Planish</h1>
      <div class="bar-group grow">
        <SampleChooser />
        <BarButton
          icon="folder"
          label="Open file"
          keys="Ctrl O"
          disabled={!ready.value}
          onClick={() => void pickAndOpen()}
        />
      </div>
      <div class="bar-group">
        <BarButton
          icon="undo"
          label="Undo"
          keys="Ctrl Z"
          disabled={!canUndo.value}
          onClick={() => void undo()}
        />
        <BarButton
          icon="redo"
          label="Redo"
          keys="Ctrl Shift Z"
          disabled={!canRedo.value}
          onClick={() => void redo()}
        />
      </div>
      <div class="bar-group">
        <ExportMenu />
        <ShareDialog />
        <HelpDialog />
      </div>
    </header>
  );
}

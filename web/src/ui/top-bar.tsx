// SPDX-License-Identifier: MIT

import { SAMPLES } from "../design/samples.ts";
import { offeredFigures, openFigure, shownFigure } from "../state/figures.ts";
import { openSample } from "../state/opening.ts";
import { CommandButton } from "./command-button.tsx";
import { COMMANDS } from "./commands/commands.ts";
import { ExportMenu } from "./export-menu.tsx";
import { Icon } from "./icon.tsx";
import { usePage } from "./page-context.ts";
import { BarEnd } from "./places.ts";
import type { Region } from "./regions.ts";

function SampleChooser() {
  const page = usePage();
  const source = page.history.value?.present.source;
  const value = shownFigure(page).value?.name ?? (source?.kind === "sample" ? source.name : "");
  return (
    <select
      aria-label="Sample"
      class="select"
      disabled={!page.ready.value}
      value={value}
      onChange={({ currentTarget }) => {
        if (!openFigure(page, currentTarget.value)) void openSample(page, currentTarget.value);
      }}
    >
      {value === "" && (
        <option value="" disabled>
          {page.designName.value}
        </option>
      )}
      {SAMPLES.map((sample) => (
        <option key={sample.name} value={sample.name}>
          {sample.label}
        </option>
      ))}
      <optgroup label="Figures of the paper">
        {offeredFigures(page).value.map((figure) => (
          <option key={figure.name} value={figure.name}>
            {figure.label}
          </option>
        ))}
      </optgroup>
    </select>
  );
}

interface SkipLinkProps {
  readonly to: Region;
  readonly children: string;
}

/** Seen while it has the focus. The page's address stays: it names designs. */
function SkipLink({ to, children }: SkipLinkProps) {
  const skip = (event: MouseEvent): void => {
    event.preventDefault();
    void import("./regions.ts").then((regions) => regions.enterRegion(to));
  };
  return (
    <a class="skip-link" href={`#${to}`} onClick={skip}>
      {children}
    </a>
  );
}

const SAVE = { ...COMMANDS.save, label: "Save" };
const SNAPSHOT = { ...COMMANDS.takeSnapshot, label: "Snapshot" };

export function TopBar() {
  return (
    <header class="top-bar">
      <SkipLink to="view">Skip to the 3D view</SkipLink>
      <SkipLink to="inspector">Skip to the controls</SkipLink>
      <h1 class="brand">Planish</h1>
      <div class="bar-group grow">
        <SampleChooser />
        <CommandButton look="bar-button" icon={<Icon name="folder" />} command={COMMANDS.open} />
        <CommandButton look="bar-button roomy" icon={<Icon name="save" />} command={SAVE} />
      </div>
      <div class="bar-group">
        <CommandButton look="bar-button" icon={<Icon name="undo" />} command={COMMANDS.undo} />
        <CommandButton look="bar-button" icon={<Icon name="redo" />} command={COMMANDS.redo} />
        <CommandButton look="bar-button" icon={<Icon name="camera" />} command={SNAPSHOT} />
      </div>
      <div class="bar-group">
        <ExportMenu />
        <BarEnd />
      </div>
    </header>
  );
}

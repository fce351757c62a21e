// SPDX-License-Identifier: MIT
// The name of something that is kept, and how to be rid of it.
import { Icon } from "./icon.tsx";
import "./designs.css";

interface NameFieldProps {
  readonly name: string;
  /** What it makes of the name is shown; where it stays as it was, so does the field. */
  readonly onRename: (to: string) => void;
}

export const NameField = ({ name, onRename }: NameFieldProps) => (
  <input
    type="text"
    class="snapshot-name"
    aria-label={`Name of ${name}`}
    value={name}
    maxLength={100}
    onChange={({ currentTarget }) => {
      const to = currentTarget.value;
      currentTarget.value = name;
      onRename(to);
    }}
  />
);

export const DeleteButton = ({ name, onDelete }: { name: string; onDelete: () => void }) => (
  <button type="button" class="icon-button" aria-label={`Delete ${name}`} onClick={onDelete}>
    <Icon name="close" />
  </button>
);

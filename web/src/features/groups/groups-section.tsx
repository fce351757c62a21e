// SPDX-License-Identifier: MIT
// Named sets of points or panels: to select, lock, stiffen, hide and colour together.
import { useEffect } from "preact/hooks";
import { GROUP_COLOURS, type Group } from "../../design/groups.ts";
import { counted } from "../../quantity/counted.ts";
import {
  addGroup,
  deleteGroup,
  followGroups,
  groups,
  hideGroup,
  isGroupHidden,
  isLocked,
  lockGroup,
  recolourGroup,
  renameGroup,
  selectedMembers,
  selectGroup,
  stiffen,
  stiffnessOf,
} from "../../state/groups.ts";
import { Ask } from "../../ui/ask.tsx";
import { DeleteButton, NameField } from "../../ui/name-field.tsx";
import { usePage } from "../../ui/page-context.ts";
import "./groups.css";

const WILLS: readonly (readonly [string, string])[] = [
  ["", "move as all others"],
  ["4", "move less willingly"],
  ["30", "hardly move"],
];

const MIXED = "mixed";

const memberWords = (of: Group["of"], count: number): string =>
  counted(count, of === "points" ? "point" : "panel");

function Will({ group }: { group: Group }) {
  const page = usePage();
  const own = stiffnessOf(page, group) ?? MIXED;
  const other = own === MIXED ? "move differently" : `stiffness ${own}`;
  const known = WILLS.some(([stiffness]) => stiffness === own);
  return (
    <select
      class="select"
      aria-label={`How willingly ${group.name} moves`}
      value={own}
      disabled={!page.ready.value}
      onChange={({ currentTarget: { value } }) => {
        if (value !== MIXED) void stiffen(page, group, value);
      }}
    >
      {(known ? WILLS : ([[own, other], ...WILLS] as const)).map(([stiffness, words]) => (
        <option key={stiffness} value={stiffness}>
          {words}
        </option>
      ))}
    </select>
  );
}

interface DoingProps {
  readonly what: string;
  readonly name: string;
  readonly pressed?: boolean;
  readonly title?: string;
  readonly disabled?: boolean;
  readonly onClick: () => void;
}

const Doing = ({ what, name, pressed, ...others }: DoingProps) => (
  <button
    type="button"
    class="tool"
    aria-label={`${what} ${name}`}
    aria-pressed={pressed}
    {...others}
  >
    {what}
  </button>
);

function Doings({ group }: { group: Group }) {
  const page = usePage();
  const { name } = group;
  const usable = page.ready.value && page.baseFlat.value && !page.readOnly.value;
  return (
    <div class="group-doings">
      <Doing what="Select" name={name} onClick={() => selectGroup(page, group)} />
      <Doing
        what="Lock"
        name={name}
        pressed={isLocked(page, group)}
        title="Its points do not move: they are pinned"
        disabled={!usable}
        onClick={() => void lockGroup(page, group)}
      />
      <Doing
        what="Hide"
        name={name}
        pressed={isGroupHidden(page, group)}
        onClick={() => hideGroup(page, group)}
      />
      <Will group={group} />
    </div>
  );
}

function Row({ group }: { group: Group }) {
  const page = usePage();
  const { name, of, members, colour } = group;
  const background = colour === null ? "none" : GROUP_COLOURS[colour];
  return (
    <li class="named-group">
      <div class="group-head">
        <button
          type="button"
          class="group-colour"
          aria-label={`Colour of ${name}: ${colour === null ? "none" : `${colour + 1} of ${GROUP_COLOURS.length}`}`}
          title="Next colour"
          onClick={() => recolourGroup(page, group)}
        >
          <span style={{ background }} />
        </button>
        <NameField name={name} onRename={(to) => renameGroup(page, group, to)} />
        <span class="quiet small">{memberWords(of, members.length)}</span>
        <DeleteButton name={name} onDelete={() => deleteGroup(page, group)} />
      </div>
      <Doings group={group} />
    </li>
  );
}

function Add({ of, words }: { of: Group["of"]; words: string }) {
  const page = usePage();
  const { length } = selectedMembers(page, of);
  return (
    <button
      type="button"
      class="button grow"
      disabled={length === 0}
      title={length === 0 ? "Select points or a panel first" : memberWords(of, length)}
      onClick={() => addGroup(page, of)}
    >
      {words}
    </button>
  );
}

export function GroupsSection() {
  const page = usePage();
  useEffect(() => followGroups(page), []);
  const list = groups(page).value;
  return (
    <section class="step" aria-labelledby="groups">
      <h2 id="groups">Groups</h2>
      <Ask about="groups" />
      <div class="row">
        <Add of="points" words="Group points" />
        <Add of="panels" words="Group panels" />
      </div>
      {list.length > 0 && (
        <ul class="snapshots" aria-labelledby="groups">
          {list.map((group) => (
            <Row key={group.name} group={group} />
          ))}
        </ul>
      )}
    </section>
  );
}

// SPDX-License-Identifier: MIT
import { AllCommands, HelpKeys, Keys } from "./help-keys.tsx";

interface Hint {
  /** What is pressed or done; a name of a key is in brackets: "[Ctrl] while dragging". */
  readonly how: string;
  readonly what: string;
}

const HINTS: readonly Hint[] = [
  {
    how: "Drag a point",
    what: "moves it up or down, on a steep surface in or out, and where that points at you, across the screen; its neighbours follow",
  },
  { how: "[Alt] while dragging", what: "moves it freely in the plane of the screen" },
  {
    how: "Drag beside a point",
    what: "turns the view about the selected point, or the place pressed; right button or two fingers pan, the wheel zooms to the pointer",
  },
  {
    how: "Drag by a finger",
    what: "shows in a loupe what it covers; then Keep or Discard beside the point",
  },
  {
    how: "[Shift] while dragging",
    what: "goes through where folds hold the drag back",
  },
  {
    how: "[0] to [9] while dragging",
    what: "say how far it goes, a minus the other way; [Enter] ends it there",
  },
  { how: "[Ctrl] while dragging", what: "goes in steps, and back to where the point was" },
  {
    how: "[Ctrl] click, [Shift] drag, [Shift] [Alt] drag",
    what: "add a point to the selection, all in a box, or all that a loop goes round, those behind the surface too; they move together",
  },
  {
    how: "Double click on an edge",
    what: "selects the line of the mesh through it, with Alt the strip of panels across it; with Ctrl adds",
  },
  { how: "Rest on a point", what: "says how far it moved, or what its colour stands for" },
  { how: "Click a panel", what: "shows its figure; close by is enough where it is narrow" },
  {
    how: "To move a point by keys",
    what: "step to it, press M (X, Y or Z first for another axis), and type by how much",
  },
  {
    how: "Coordinates",
    what: "take units and arithmetic: 1.2m, 3*400mm; +50mm adds, -=50mm takes away",
  },
];

export function HelpText() {
  return (
    <>
      <p>
        Move a point of a structure made of flat panels. The few points that must follow do;
        everything else keeps its coordinates to the last bit, and every panel stays flat to one
        millionth of a millimetre per metre.
      </p>
      <p>
        While a point is dragged, each picture follows from the one before, and what it shows on
        release stays: the edit is solved afresh from the mesh that was opened, at once or in steps,
        whichever leads there. Where another solution is lower, it is offered. To start from a shape
        instead, a variation for example, use Continue from this shape.
      </p>
      <p>
        <a href="./guide/index.html" target="_blank" rel="noopener">
          The guide
        </a>{" "}
        has every control, the formats and a glossary. <AllCommands />
      </p>
      <dl class="keys">
        {HINTS.map(({ how, what }) => (
          <div key={how}>
            <dt>
              <Keys text={how} />
            </dt>
            <dd>{what}</dd>
          </div>
        ))}
        <HelpKeys />
      </dl>
      <p class="quiet">
        Flatness of a panel is the distance between the two planes, parallel to its best-fit plane,
        that hold all its corners; in mm/m it is divided by the panel's longest edge.
      </p>
    </>
  );
}

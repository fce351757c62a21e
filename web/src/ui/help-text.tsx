// SPDX-License-Identifier: MIT
const KEYS: readonly (readonly [string, string])[] = [
  ["Drag a point", "moves it; its neighbours follow"],
  ["Drag beside the model", "turns the view; right button or two fingers pan, wheel zooms"],
  ["X, Y, Z, N", "hold a drag to an axis or to the normal; with Shift, to the plane across"],
  ["Ctrl while dragging", "goes in steps, and back to where the point was"],
  ["Ctrl + click, Shift + drag", "select several points, or a box of them; they move together"],
  ["P", "pins the selected points, or lets them go"],
  ["Click a panel", "shows its figure"],
  ["Arrow keys in the view", "step from point to point; with Ctrl, add the next point"],
  ["Shift + arrow keys", "turn the view; + and − zoom"],
  ["1, 2, 3, 4, F", "perspective, top, front, side; fit the model into the view"],
  ["B, held", "shows the design before the edit"],
  ["Esc", "gives up a drag; otherwise selects nothing"],
  ["Ctrl Z, Ctrl Shift Z", "undo, redo"],
  ["Ctrl O", "opens a file"],
  ["Coordinates", "take units and arithmetic: 1.2m, 3*400mm, +50mm adds"],
];

export function HelpText() {
  return (
    <>
      <p>
        Move a point of a structure made of flat panels. The few points that must follow do;
        everything else keeps its coordinates to the last bit, and every panel stays flat to one
        millionth of a millimetre per metre.
      </p>
      <dl class="keys">
        {KEYS.map(([key, what]) => (
          <div key={key}>
            <dt>{key}</dt>
            <dd>{what}</dd>
          </div>
        ))}
      </dl>
      <p class="quiet">
        Flatness of a panel is the distance between the two planes, parallel to its best-fit plane,
        that hold all its corners; in mm/m it is divided by the panel's longest edge.
      </p>
    </>
  );
}

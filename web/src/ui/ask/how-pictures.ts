// SPDX-License-Identifier: MIT
// What the moving pictures of the help show: lines of a structure seen from the side.
import {
  along,
  arch,
  before,
  both,
  bump,
  circle,
  columnX,
  corners,
  FLAT,
  type HowPicture,
  level,
  MIDDLE,
  type Moment,
  mesa,
  PANEL,
  pointAt,
  raised,
  risen,
  STRIP_HIGH,
  STRIP_LOW,
  seenFrom,
  sharp,
  slid,
  strip,
  stripLine,
  upright,
  wall,
  wide,
  zigzag,
} from "./how-shapes.ts";

export const HOW_PICTURES = {
  edit: {
    name: "moving points",
    words:
      "Drag a point. A few neighbours follow so that every panel stays flat; everything else keeps its place to the last bit.",
    lines: [before, strip(FLAT, raised), pointAt(MIDDLE, FLAT, raised)],
  },
  reach: {
    name: "reach",
    words: "How many panels away points may follow. Beyond the line nothing moves.",
    lines: [
      strip(bump(30, 2), bump(30, 4)),
      wall(upright(columnX(3)), upright(columnX(1))),
      wall(upright(columnX(7)), upright(columnX(9))),
    ],
  },
  softness: {
    name: "softness",
    words:
      "Close and firm, or wide and gentle: the same pull bends few panels much or many a little.",
    lines: [before, strip(sharp, wide), pointAt(MIDDLE, sharp, wide)],
  },
  boundary: {
    name: "the boundary",
    words:
      "Fixed, the boundary stays where it is drawn, but for points that you drag. Else it is free, or keeps its level, its outline or the surface.",
    lines: [
      before,
      strip(
        FLAT,
        both(raised, (k) => 3 * (k - MIDDLE)),
        raised,
      ),
      pointAt(0, FLAT, () => -15, FLAT),
      pointAt(10, FLAT, () => 15, FLAT),
    ],
  },
  limits: {
    name: "limits",
    words:
      "Folds, angles and sizes that no panel may exceed. A drag goes as far as they let it; Shift goes through.",
    lines: [before, strip(FLAT, sharp, bump(17, 3)), pointAt(MIDDLE, FLAT, sharp, bump(17, 3))],
  },
  circular: {
    name: "circular panels",
    words:
      "The corners of every panel stay on a circle: beams of one height then meet in one axis at every point.",
    lines: [
      { look: "still", moments: [circle] },
      { look: "strip", moments: [corners(0), corners(0.7)] },
    ],
  },
  conical: {
    name: "conical nodes",
    words:
      "The panels around every point touch one cone: a layer at a constant distance from them has flat panels, too.",
    lines: [
      strip(FLAT, raised),
      strip(
        (k) => 14 + FLAT(k),
        (k) => 14 + raised(k),
      ),
    ],
  },
  advanced: {
    name: "the weights",
    words: "How much it costs to move many points, and how much to bend: the paper's own weights.",
    lines: [strip(bump(26, 1.6), bump(26, 3), bump(26, 5))],
  },
  along: {
    name: "moving along the surface",
    words: "Points go along the surface, across it or out of it, not along x, y and z.",
    lines: [
      { look: "still", moments: [risen(FLAT)] },
      { look: "strip", moments: [slid(0), slid(1)] },
      {
        look: "point",
        moments: [slid(0), slid(1)].map((moment) => moment.slice(MIDDLE, MIDDLE + 1)),
      },
    ],
  },
  supports: {
    name: "supports",
    words:
      "What a point stands on: it keeps its level, goes up and down only, or stays on its line. Its coordinates keep every digit.",
    lines: [
      strip(FLAT, (k) => (k === 0 || k === 10 ? 0 : raised(k))),
      wall(level(72)),
      pointAt(0, FLAT),
      pointAt(10, FLAT),
    ],
  },
  keepOuts: {
    name: "keep-outs",
    words: "Where nothing may go: the edit stops beside it, at its clearance.",
    lines: [
      wall([
        [70, 24],
        [170, 24],
      ]),
      strip(FLAT, bump(22, 3)),
      pointAt(MIDDLE, FLAT, bump(22, 3)),
    ],
  },
  symmetry: {
    name: "symmetry",
    words: "What is done to one point is done to all its images.",
    lines: [
      wall(upright(columnX(MIDDLE))),
      strip(FLAT, both(bump(24, 2.5, 2), bump(24, 2.5, 8))),
      pointAt(2, FLAT, bump(24, 2.5, 2)),
      pointAt(8, FLAT, bump(24, 2.5, 8)),
    ],
  },
  explore: {
    name: "variations",
    words:
      "Other shapes with flat panels about the same edit: a slider for each way it can still move.",
    lines: [
      before,
      strip(
        both(raised, bump(12, 3, 2)),
        both(raised, bump(-12, 3, 2)),
        both(raised, bump(12, 3, 8)),
      ),
      pointAt(MIDDLE, raised, raised, raised),
    ],
  },
  exact: {
    name: "making exact",
    words:
      "A variation is nearly flat; made exact, every panel is flat to a millionth of a millimetre per metre.",
    lines: [strip(both(raised, zigzag(4)), raised)],
  },
  groups: {
    name: "groups",
    words:
      "Points or panels under a name: to select, lock, hide or colour together, or to move less willingly than the others.",
    lines: [
      before,
      strip(FLAT, bump(30, 4), (k) => bump(30, 4)(k) * (k < MIDDLE ? 0.25 : 1)),
      pointAt(MIDDLE, FLAT, bump(30, 4), bump(30, 4)),
    ],
  },
  section: {
    name: "the section",
    words: "A plane cuts the view open; the cut is a line that can be measured and exported.",
    lines: [strip(raised), wall(upright(60), upright(180))],
  },
  snapshots: {
    name: "snapshots",
    words: "Keep a design to come back to, or two to four of them to compare side by side.",
    lines: [
      { look: "still", moments: [risen(wide)] },
      { look: "still", moments: [risen(sharp)] },
      strip(sharp, wide, raised),
    ],
  },
  views: {
    name: "named views",
    words: "Keep where you look from, under a name. Links and saved designs carry it.",
    lines: [{ look: "strip", moments: [seenFrom(1, 0), seenFrom(0.6, 3), seenFrom(0.8, -3)] }],
  },
  measure: {
    name: "measuring",
    words: "Distances, angles and sizes of what is selected, as values to copy.",
    lines: [
      strip(raised),
      wall(
        [
          [columnX(2), arch(2) - 14],
          [columnX(2), arch(2) - 14],
        ],
        [
          [columnX(2), 14],
          [columnX(8), 14],
        ],
      ),
      pointAt(2, raised),
      pointAt(8, raised),
    ],
  },
  position: {
    name: "the position",
    words:
      "Where the point is, in the file, from a point of your own, and from where it was. +50 adds 50 to a coordinate.",
    lines: [
      before,
      strip(FLAT, raised),
      pointAt(MIDDLE, FLAT, raised),
      wall(
        [
          [columnX(0), arch(0)],
          [columnX(MIDDLE), arch(0)],
          [columnX(MIDDLE), arch(MIDDLE)],
        ],
        [
          [columnX(0), arch(0)],
          [columnX(MIDDLE), arch(0)],
          [columnX(MIDDLE), arch(MIDDLE) - 30],
        ],
      ),
    ],
  },
  colours: {
    name: "the colours",
    words:
      "What the colours stand for: how far points moved, how flat panels are, how sharply they fold. A class of the scale leads to its panels.",
    lines: [
      before,
      strip(FLAT, raised),
      ...[3, 4, 5, 6, 7].map((k) => pointAt(k, FLAT, raised)),
      wall(
        [
          [20, 88],
          [20, 88],
        ],
        [
          [20, 88],
          [220, 88],
        ],
      ),
    ],
  },
  tools: {
    name: "the drag tools",
    words:
      "Select in a box or a loop, pin, hold drags to an axis or to the normal, go in steps. While you drag, type how far it goes.",
    lines: [
      before,
      strip(FLAT, bump(14, 3), bump(28, 3)),
      pointAt(MIDDLE, FLAT, bump(14, 3), bump(28, 3)),
      wall(upright(columnX(MIDDLE))),
    ],
  },
  cut: {
    name: "cutting",
    words:
      "A line parts a panel, or a whole strip. Its parts are as flat as it was, and no point moves: what holds a handle back may let it go.",
    lines: [
      wall(PANEL),
      wall(...[0, 1, 1].map((share): Moment => [PANEL[0], along(PANEL[0], PANEL[2], share)])),
      { look: "point", moments: [0, 1, 1].map((share) => [along(PANEL[0], PANEL[2], share)]) },
    ],
  },
  cutStrip: {
    name: "cutting a strip",
    words:
      "A line of points goes through all quads of a strip, until the boundary or a panel that is no quad. No point moves.",
    lines: [
      wall([...STRIP_LOW, ...[...STRIP_HIGH].reverse(), STRIP_LOW[0]]),
      ...[1, 2].map((k) => wall([STRIP_LOW[k] ?? [0, 0], STRIP_HIGH[k] ?? [0, 0]])),
      wall(...[0, 1, 2, 3, 3].map(stripLine)),
      { look: "point", moments: [0, 1, 2, 3, 3].map((k) => stripLine(k).slice(-1)) },
    ],
  },
  cutCorner: {
    name: "cutting a corner off",
    words:
      "A triangle goes off a panel at one corner, as far along both sides as is chosen. Where all panels at a point lose theirs, it can go anywhere.",
    lines: [
      wall(PANEL),
      wall(
        ...[0, 0.5, 1, 1].map(
          (share): Moment => [along(PANEL[2], PANEL[3], share), along(PANEL[2], PANEL[1], share)],
        ),
      ),
      { look: "point", moments: [[PANEL[2]], [PANEL[2]], [PANEL[2]], [PANEL[2]]] },
    ],
  },
  splitWhereNeeded: {
    name: "splitting where needed",
    words:
      "Flat panels hold a point. One more line through a panel beside it lets it go further: for each number of lines you see how far, and what is made again.",
    lines: [
      before,
      wall([
        [columnX(MIDDLE) - 9, arch(MIDDLE) - 30],
        [columnX(MIDDLE) + 9, arch(MIDDLE) - 30],
      ]),
      strip(FLAT, bump(14, 3), bump(14, 3), sharp),
      pointAt(MIDDLE, FLAT, bump(14, 3), bump(14, 3), sharp),
    ],
  },
  numbers: {
    name: "the numbers",
    words:
      "Numbers of panels and points, as tables, reports and the command line give them: on those in sight, where there is room.",
    lines: [strip(raised, wide), ...[1, 3, 5, 7, 9].map((k) => pointAt(k, raised, wide))],
  },
  several: {
    name: "several points",
    words:
      "A box, a loop, the boundary or a line selects many points, which move together. With fall-off they rise as a bump, not as a mesa.",
    lines: [
      before,
      strip(FLAT, mesa, bump(24, 4)),
      ...[3, 4, 5, 6, 7].map((k) => pointAt(k, FLAT, mesa, bump(24, 4))),
    ],
  },
  note: {
    name: "the note",
    words: "A few words to whoever gets the design. They go along with links and saved designs.",
    lines: [
      {
        look: "strip",
        moments: [
          [
            [60, 40],
            [62, 40],
          ],
          [
            [60, 40],
            [180, 40],
          ],
        ],
      },
      {
        look: "strip",
        moments: [
          [
            [60, 58],
            [62, 58],
          ],
          [
            [60, 58],
            [140, 58],
          ],
        ],
      },
    ],
  },
} satisfies Readonly<Record<string, HowPicture>>;

export type Subject = keyof typeof HOW_PICTURES;

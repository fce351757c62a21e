// SPDX-License-Identifier: MIT
// What the moving pictures of the help are put together from: rows of places, a row a moment, in a field of
// 240 × 96.

type Point = readonly [x: number, y: number];
export type Moment = readonly Point[];

export interface HowLine {
  readonly look: "strip" | "still" | "wall" | "point";
  readonly moments: readonly Moment[];
}

export interface HowPicture {
  readonly name: string;
  readonly words: string;
  readonly lines: readonly HowLine[];
}

const COLUMNS = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10];
export const MIDDLE = 5;

export const columnX = (k: number): number => 20 + 20 * k;

export const arch = (k: number): number => 72 - 0.9 * k * (10 - k);

type Rise = (k: number) => number;

export const FLAT: Rise = () => 0;

/** A bump `height` high over a place, `width` columns to each side. */
export const bump =
  (height: number, width: number, at = MIDDLE): Rise =>
  (k) => {
    const away = Math.abs(k - at) / width;
    return away < 1 ? (height * (1 + Math.cos(Math.PI * away))) / 2 : 0;
  };

export const both =
  (one: Rise, other: Rise): Rise =>
  (k) =>
    one(k) + other(k);

export const risen = (rise: Rise): Moment =>
  COLUMNS.map((k) => [columnX(k), arch(k) - rise(k)] as const);

export const strip = (...rises: Rise[]): HowLine => ({ look: "strip", moments: rises.map(risen) });

export const before: HowLine = { look: "still", moments: [risen(FLAT)] };

/** The mark of one point of a strip. */
export const pointAt = (k: number, ...rises: Rise[]): HowLine => ({
  look: "point",
  moments: rises.map((rise) => [[columnX(k), arch(k) - rise(k)] as const]),
});

export const wall = (...moments: Moment[]): HowLine => ({ look: "wall", moments });

export const upright = (x: number): Moment => [
  [x, 8],
  [x, 88],
];

export const level = (y: number): Moment => [
  [8, y],
  [232, y],
];

export const raised = bump(30, 3);
export const sharp = bump(30, 1.6);
export const wide = bump(30, 5);
export const zigzag =
  (size: number): Rise =>
  (k) =>
    size * (k % 2 === 0 ? 1 : -1);
export const mesa: Rise = (k) => (k >= 3 && k <= 7 ? 24 : 0);

const onCircle = (angle: number): Point => [120 + 40 * Math.cos(angle), 48 + 40 * Math.sin(angle)];

/** Four corners on the circle, closed. */
export const corners = (turn: number): Moment =>
  [0.3, 1.7, 3.6, 5.2, 0.3].map((angle) => onCircle(angle + turn));

export const circle: Moment = Array.from({ length: 33 }, (_, k) =>
  onCircle((2 * Math.PI * k) / 32),
);

export const seenFrom = (width: number, lift: number): Moment =>
  COLUMNS.map((k) => [120 + (columnX(k) - 120) * width, arch(k) + lift * (k - 5)] as const);

export const slid = (by: number): Moment =>
  COLUMNS.map((k) => {
    const x = k + by * bump(1, 4)(k);
    return [columnX(x), arch(x)] as const;
  });

export const PANEL: readonly [Point, Point, Point, Point, Point] = [
  [60, 78],
  [172, 84],
  [186, 22],
  [74, 14],
  [60, 78],
];

export const along = (a: Point, b: Point, share: number): Point => [
  a[0] + share * (b[0] - a[0]),
  a[1] + share * (b[1] - a[1]),
];

/** The two long sides of a strip of three quads, a place a side across. */
export const STRIP_LOW: readonly [Point, Point, Point, Point] = [
  [30, 80],
  [92, 86],
  [152, 84],
  [212, 76],
];
export const STRIP_HIGH: readonly [Point, Point, Point, Point] = [
  [36, 20],
  [94, 14],
  [150, 16],
  [206, 24],
];

/** A line along the middle of that strip that has come through `quads` of it. */
export const stripLine = (quads: number): Moment =>
  STRIP_LOW.map((_, k) => {
    const reached = Math.min(k, quads);
    return along(STRIP_LOW[reached] ?? STRIP_LOW[3], STRIP_HIGH[reached] ?? STRIP_HIGH[3], 0.5);
  });

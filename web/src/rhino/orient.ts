// SPDX-License-Identifier: MIT
// Outlines are drawn either way round; panels of one surface have their outside on one side.

/** Faces by the side that they have from `a` to `b`. */
function bySide(faces: readonly (readonly number[])[]): Map<string, number[]> {
  const sides = new Map<string, number[]>();
  faces.forEach((face, f) => {
    face.forEach((a, k) => {
      const key = `${a} ${face[(k + 1) % face.length]}`;
      const there = sides.get(key);
      if (there) there.push(f);
      else sides.set(key, [f]);
    });
  });
  return sides;
}

/** Faces that share a side with face `f`, and whether both run along it the same way. */
function* neighbours(
  f: number,
  face: readonly number[],
  sides: ReadonlyMap<string, readonly number[]>,
): Iterable<readonly [number, boolean]> {
  for (let k = 0; k < face.length; ++k) {
    const [a, b] = [face[k], face[(k + 1) % face.length]];
    const same = (sides.get(`${a} ${b}`) ?? []).filter((other) => other !== f);
    const against = sides.get(`${b} ${a}`) ?? [];
    if (same.length + against.length !== 1) continue; // a boundary, or more than two panels
    for (const other of same) yield [other, true];
    for (const other of against) yield [other, false];
  }
}

/** Turns faces round until neighbours agree; the first of each part stays as it is. */
export function orient(faces: readonly (readonly number[])[]): readonly (readonly number[])[] {
  const sides = bySide(faces);
  const turned = new Map<number, boolean>();
  for (let first = 0; first < faces.length; ++first) {
    if (turned.has(first)) continue;
    turned.set(first, false);
    const waiting = [first];
    for (let f = waiting.pop(); f !== undefined; f = waiting.pop()) {
      for (const [other, same] of neighbours(f, faces[f] ?? [], sides)) {
        if (turned.has(other)) continue;
        turned.set(other, (turned.get(f) ?? false) !== same);
        waiting.push(other);
      }
    }
  }
  return faces.map((face, f) => (turned.get(f) ? face.toReversed() : face));
}

// SPDX-License-Identifier: MIT
// The large mesh of the scripts that measure what the workshop gets.

/** A doubly curved roof of `side`² parallelograms, a metre each. */
export function quadRoof(side) {
  const height = (t) => 0.12 * side * Math.sin((Math.PI * t) / side);
  const point = (i, j) => [i, j, height(i) + height(j)];
  const points = [];
  for (let j = 0; j <= side; ++j) for (let i = 0; i <= side; ++i) points.push(point(i, j));
  const faces = [];
  for (let j = 0; j < side; ++j)
    for (let i = 0; i < side; ++i) {
      const a = j * (side + 1) + i;
      faces.push([a, a + 1, a + side + 2, a + side + 1]);
    }
  const lines = points.map((p) => `v ${p.join(" ")}`);
  for (const face of faces) lines.push(`f ${face.map((v) => v + 1).join(" ")}`);
  return { points, faces, obj: `${lines.join("\n")}\n` };
}

// SPDX-License-Identifier: MIT
// Small charts as SVG.

/** Slider values as bars up and down from a line. */
export function barChart(values) {
  const [width, height] = [34 * values.length + 12, 92];
  const middle = height / 2;
  const scale = (middle - 8) / Math.max(1, ...values.map(Math.abs));
  const bars = values.map((x, k) => {
    const length = Math.max(1, Math.abs(x) * scale);
    const y = x >= 0 ? middle - length : middle;
    return `<rect x="${10 + 34 * k}" y="${y}" width="24" height="${length}" fill="#2453d6"/>`;
  });
  return `<svg class="bars" width="${width}" height="${height}"><line x1="4" x2="${width - 4}" y1="${middle}" y2="${middle}" stroke="#555"/>${bars.join("")}</svg>`;
}

const SIZE = { width: 760, height: 520, left: 90, right: 20, top: 50, bottom: 60 };

function polyline(points, colour, label) {
  const last = points.at(-1);
  const line = points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" ");
  return `<polyline points="${line}" fill="none" stroke="${colour}" stroke-width="2.5"/>
    <text x="${last[0] - 6}" y="${last[1] - 10}" text-anchor="end" fill="${colour}">${label}</text>`;
}

/** ‖h‖, ‖r‖ and μ of every outer step of the reference engine. */
export function residualChart(records) {
  const { width, height, left, right, top, bottom } = SIZE;
  const columns = [
    ["primal_residual", "#b3402a", "‖h‖, primal"],
    ["dual_residual", "#2453d6", "‖r‖, dual"],
    ["penalty", "#5a5a5a", "μ, penalty"],
  ];
  const values = records
    .flatMap((record) => columns.map(([column]) => record[column]))
    .filter((x) => x > 0);
  const low = Math.floor(Math.log10(Math.min(...values)));
  const high = Math.ceil(Math.log10(Math.max(...values)));
  const x = (k) => left + ((width - left - right) * k) / Math.max(1, records.length - 1);
  const y = (value) => top + ((height - top - bottom) * (high - Math.log10(value))) / (high - low);
  const grid = [];
  for (let power = low; power <= high; ++power) {
    const at = y(10 ** power);
    grid.push(`<line x1="${left}" x2="${width - right}" y1="${at}" y2="${at}" stroke="#ddd"/>
      <text x="${left - 8}" y="${at + 6}" text-anchor="end">1e${power}</text>`);
  }
  const lines = columns.map(([column, colour, label]) =>
    polyline(
      records.map((record, k) => [x(k), y(Math.max(record[column], 10 ** low))]),
      colour,
      label,
    ),
  );
  return `<svg viewBox="0 0 ${width} ${height}" style="width:100%;background:#fff" font-size="18">
    ${grid.join("")}${lines.join("")}
    <text x="${(left + width) / 2}" y="${height - 16}" text-anchor="middle">dual updates (1 to ${records.length})</text></svg>`;
}

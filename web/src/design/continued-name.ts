// SPDX-License-Identifier: MIT
const CONTINUED = /, continued(?: (\d+))?$/;

/** "roof.obj", "roof, continued.obj", "roof, continued 2.obj" */
export function continuedName(name: string): string {
  const stem = name.replace(/\.[a-z]{3}$/i, "");
  const times = CONTINUED.exec(stem);
  if (!times) return `${stem}, continued.obj`;
  return `${stem.replace(CONTINUED, "")}, continued ${Number(times[1] ?? 1) + 1}.obj`;
}

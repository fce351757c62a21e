// SPDX-License-Identifier: MIT
/** Rows of a table as the core writes it: RFC 4180, names and numbers, so that no cell is quoted. */
export function csvRows(csv: string): Readonly<Record<string, string>>[] {
  const [head = "", ...lines] = csv.split("\r\n").filter((line) => line !== "");
  const fields = head.split(",");
  return lines.map((line) => {
    const cells = line.split(",");
    return Object.fromEntries(fields.map((field, k) => [field, cells[k] ?? ""]));
  });
}

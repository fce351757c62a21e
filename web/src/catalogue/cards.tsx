// SPDX-License-Identifier: MIT
// One card a design: picture, values, figures, and the way into the editor.
import { type Cell, type DesignRow, labelOf, shownColumns, type Table } from "./table.ts";

interface Props {
  readonly table: Table;
  readonly designs: readonly DesignRow[];
  /** The pointer or the keyboard is on it; null: on none. */
  readonly onPoint: (design: DesignRow | null) => void;
}

const ID_SHOWN = 8;

const written = (cell: Cell): string =>
  typeof cell === "number" ? String(Number(cell.toPrecision(5))) : (cell ?? "–");

function Figures({ table, design }: { readonly table: Table; readonly design: DesignRow }) {
  return (
    <dl>
      {shownColumns(table).map((k) => {
        const column = table.columns[k];
        return column ? (
          <div key={k} class={column.kind}>
            <dt>{labelOf(column)}</dt>
            <dd>{written(design.cells[k] ?? null)}</dd>
          </div>
        ) : null;
      })}
    </dl>
  );
}

function Doors({ design, name }: { readonly design: DesignRow; readonly name: string }) {
  return (
    <p class="doors">
      {design.link && (
        <a href={design.link} aria-label={`Open in the editor: ${name}`}>
          Open in the editor
        </a>
      )}
      {design.file && (
        <a href={design.file} download aria-label={`Design file of ${name}`}>
          Design file
        </a>
      )}
    </p>
  );
}

function Card({ table, design, onPoint }: Omit<Props, "designs"> & { readonly design: DesignRow }) {
  const name = design.id.slice(0, ID_SHOWN);
  const here = (): void => onPoint(design);
  const gone = (): void => onPoint(null);
  return (
    <li class="card" onPointerEnter={here} onPointerLeave={gone} onFocusIn={here} onFocusOut={gone}>
      {design.picture && <img src={design.picture} alt="" loading="lazy" />}
      <h2>{name}</h2>
      <Figures table={table} design={design} />
      <Doors design={design} name={name} />
    </li>
  );
}

export const Cards = ({ table, designs, onPoint }: Props) => (
  <ul class="cards" aria-label="Designs">
    {designs.map((design) => (
      <Card key={design.id} table={table} design={design} onPoint={onPoint} />
    ))}
  </ul>
);

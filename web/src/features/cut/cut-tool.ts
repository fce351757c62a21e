// SPDX-License-Identifier: MIT
// Clicks in the view that cut: what each kind takes a place there for.
import type { Place } from "../../scene/picking.ts";
import type { Sight } from "../../scene/sight.ts";
import type { ViewTool } from "../../scene/view-tool.ts";
import type { Page } from "../../state/page.ts";
import { CutPicking } from "./cut-picking.ts";
import { cornerText, refineText, splitText, stripText } from "./cut-text.ts";
import {
  begin,
  begun,
  collar,
  cornerShare,
  cutKind,
  cutNow,
  type Pointed,
  point,
  pointed,
  wantedCut,
} from "./cutting.ts";

/** Pixels within which a second tap means what the first did. */
const SAME_TAP = 24;

type Meant = Omit<Pointed, "of">;

const NOTHING: Meant = { cut: null, place: null };

/** The second place of a split may be on another panel that has the first. */
function meantBySplit(page: Page, picking: CutPicking, panel: number): Meant {
  const first = begun(page);
  if (!first) return { cut: null, place: picking.outline(panel) };
  const of = picking.has(panel, first.place) ? panel : first.panel;
  const place = picking.outline(of);
  return { cut: place && splitText(of, first.place, place), place };
}

function meant(page: Page, picking: CutPicking): Meant {
  const { panel } = picking;
  if (panel === null) return NOTHING;
  switch (cutKind(page).value) {
    case "split":
      return meantBySplit(page, picking, panel);
    case "strip": {
      const place = picking.side(panel)?.place ?? null;
      return { cut: place && stripText(place), place };
    }
    case "corner": {
      const place = picking.corner(panel)?.place ?? null;
      const cut = place && cornerText(panel, place.vertex, cornerShare(page).value);
      return { cut, place };
    }
    case "refine":
      return { cut: refineText([panel], collar(page).value), place: null };
    case "trim":
      return NOTHING;
  }
}

/** Takes back what was begun, or the tool. */
export function giveUpCut(page: Page): void {
  if (begun(page)) {
    begin(page, null);
    point(page, null);
  } else page.cutting.value = false;
}

export class CutTool implements ViewTool {
  readonly #page: Page;
  readonly #sight: Sight;
  /** Where a finger was shown what its next tap there does. */
  #tapped: Place | null = null;

  constructor(page: Page, sight: Sight) {
    this.#page = page;
    this.#sight = sight;
  }

  hover(at: Place | null): void {
    this.#tapped = null;
    this.#point(at, false);
  }

  /** A finger sees first what it would do, and does that with its next tap there. */
  click(at: Place, coarse: boolean): void {
    const [page, tapped] = [this.#page, this.#tapped];
    const again = tapped && Math.hypot(at.x - tapped.x, at.y - tapped.y) < SAME_TAP;
    this.#tapped = null;
    if (!(coarse && again && pointed(page)?.cut)) this.#point(at, coarse);
    if (this.#begins(at, coarse)) return;
    if (pointed(page)?.cut === undefined || wantedCut(page).value === null) return;
    if (coarse && !again) this.#tapped = at;
    else if (pointed(page)?.cut) void cutNow(page);
  }

  escape(): void {
    giveUpCut(this.#page);
  }

  #pick(at: Place, coarse: boolean): CutPicking | null {
    const { shell } = this.#sight;
    const usable = this.#page.ready.value && !this.#page.readOnly.value;
    return shell && usable ? new CutPicking(this.#sight, shell, at, coarse) : null;
  }

  #point(at: Place | null, coarse: boolean): void {
    const [page, of] = [this.#page, this.#page.displayMesh.value];
    const picking = at && of && this.#pick(at, coarse);
    point(page, picking && of ? { ...meant(page, picking), of } : null);
  }

  /** Whether this is the first place of a split. */
  #begins(at: Place, coarse: boolean): boolean {
    const [page, now] = [this.#page, pointed(this.#page)];
    if (cutKind(page).value !== "split" || begun(page) || !now?.place) return false;
    const panel = this.#pick(at, coarse)?.panel;
    if (panel === null || panel === undefined) return false;
    begin(page, { of: now.of, panel, place: now.place });
    return true;
  }
}

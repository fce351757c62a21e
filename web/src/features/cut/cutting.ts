// SPDX-License-Identifier: MIT
// What the tool is about to cut: by what is pointed at in the view, else by what is typed, else by the
// selection; and what that would leave, asked of the solver before it is made.
import { computed, effect, signal, untracked } from "@preact/signals";
import type { DisplayMesh } from "../../mesh/display-mesh.ts";
import type { CutTrial } from "../../solver/protocol.ts";
import type { Outcome } from "../../state/action-queue.ts";
import { client } from "../../state/connection.ts";
import { kept, type Page } from "../../state/page.ts";
import { fromSelection } from "./cut-selection.ts";
import { type CutKind, type OutlinePlace, refineText } from "./cut-text.ts";
import { makeCut, type TryCut } from "./cuts.ts";

export const cutKind = kept(() => signal<CutKind>("split"));

/** The share of the two sides of a corner that is cut off. */
export const cornerShare = kept(() => signal(1));

/** Whether the panels beside refined ones are split, too. */
export const collar = kept(() => signal(false));

/** The first of the two places of a split. */
export interface Begun {
  readonly of: DisplayMesh;
  readonly panel: number;
  readonly place: OutlinePlace;
}

export interface Pointed {
  readonly of: DisplayMesh;
  /** null: no cut yet. */
  readonly cut: string | null;
  /** Where it would begin or end; null for nowhere. */
  readonly place: OutlinePlace | null;
}

interface Cutting {
  readonly begun: ReturnType<typeof signal<Begun | null>>;
  readonly pointed: ReturnType<typeof signal<Pointed | null>>;
  readonly typed: ReturnType<typeof signal<string | null>>;
  readonly trial: ReturnType<typeof signal<(CutTrial & { readonly cut: string }) | null>>;
  /** Why the latest cut was not made; "" where it was, or another is wanted. */
  readonly refused: ReturnType<typeof signal<string>>;
}

const cutting = kept(
  (): Cutting => ({
    begun: signal<Begun | null>(null),
    pointed: signal<Pointed | null>(null),
    typed: signal<string | null>(null),
    trial: signal<(CutTrial & { readonly cut: string }) | null>(null),
    refused: signal(""),
  }),
);

const ofMesh = <T extends { readonly of: DisplayMesh }>(page: Page, value: T | null): T | null =>
  value && value.of === page.displayMesh.value ? value : null;

export const begun = (page: Page): Begun | null => ofMesh(page, cutting(page).begun.value ?? null);

export const pointed = (page: Page): Pointed | null =>
  ofMesh(page, cutting(page).pointed.value ?? null);

export function begin(page: Page, first: Begun | null): void {
  if (first) cutting(page).refused.value = "";
  cutting(page).begun.value = first;
}

export function point(page: Page, at: Pointed | null): void {
  if (at?.cut) cutting(page).refused.value = "";
  cutting(page).pointed.value = at;
}

/** The numbers of the form: those typed, else those that the selection says. */
export const numbers = (page: Page): string =>
  cutting(page).typed.value ?? fromSelection(page, cutKind(page).value);

export function type(page: Page, text: string | null): void {
  cutting(page).refused.value = "";
  cutting(page).typed.value = text;
}

export function chooseKind(page: Page, kind: CutKind): void {
  cutKind(page).value = kind;
  begin(page, null);
  point(page, null);
  type(page, null);
}

/** What the form says; null where it says nothing. */
function formCut(page: Page): string | null {
  const [kind, said] = [cutKind(page).value, numbers(page).replace(/\s/g, "")];
  if (said === "") return null;
  if (kind === "refine") return refineText([], collar(page).value).replace("=", `=${said}`);
  const share = cornerShare(page).value;
  const whole = kind !== "corner" || said.includes("@") || share === 1;
  return `${kind}=${said}${whole ? "" : `@${share}`}`;
}

/** The cut that is about to be made; null for none. */
export const wantedCut = kept((page) =>
  computed((): string | null => pointed(page)?.cut ?? (begun(page) ? null : formCut(page))),
);

/** What the cut that is shown would leave, once that is known. */
export function trialNow(page: Page): CutTrial | null {
  const trial = cutting(page).trial.value;
  return trial && trial.cut === wantedCut(page).value ? trial : null;
}

/** Why the wanted cut cannot be made, or the one that was asked for last was not; "" where nothing is wrong. */
export const refusalNow = (page: Page): string =>
  trialNow(page)?.problem || (cutting(page).refused.value ?? "");

/** Asked of the mesh that is open, with its symmetry. */
function tryQuestion(page: Page, cut: string): TryCut {
  const { symmetry = [], tolerance = 0 } = page.history.value?.present.settings ?? {};
  return { kind: "tryCut", cut, tolerance: symmetry.length > 0 ? tolerance : 0 };
}

async function tryOut(page: Page, cut: string): Promise<void> {
  const answer = await client(page)
    .stream(tryQuestion(page, cut))
    .catch(() => null); // Overtaken, or the solver is gone: what is shown next asks again.
  if (answer?.kind === "tried") cutting(page).trial.value = { ...answer.trial, cut };
}

/** Asks what the wanted cut would leave whenever it, or the design that it would cut, is another. */
export const followTrial = (page: Page): (() => void) =>
  effect(() => {
    const [cut, design] = [wantedCut(page).value, page.history.value?.present];
    const usable = page.ready.value && page.baseFlat.value && !page.busy.value;
    cutting(page).trial.value = null;
    if (cut === null || !design || !usable) return;
    untracked(() => void tryOut(page, cut));
  });

/** Makes the wanted cut, or says why it cannot be made. */
export async function cutNow(page: Page): Outcome {
  const cut = wantedCut(page).value;
  if (cut === null) return;
  begin(page, null);
  point(page, null);
  const end = await makeCut(page, cut, tryQuestion(page, cut));
  if (typeof end === "string") cutting(page).refused.value = end;
  else if (end?.ok) type(page, null);
  return typeof end === "string" ? undefined : end;
}

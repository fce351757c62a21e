// SPDX-License-Identifier: MIT
// The one solver of the page, and what its answers do to the state.

import { type Design, toTargets } from "../design/design.ts";
import { symmetryIn } from "../design/symmetry.ts";
import { done, GIVEN_UP, type Refusal, type Result, refuse } from "../result/result.ts";
import { Abandoned, type Answer, Died, type Question, SolverClient } from "../solver/client.ts";
import type { OpenedMesh, Planarising, Shape, Source, Symmetry } from "../solver/protocol.ts";
import { kept, type Page } from "./page.ts";
import { say } from "./telling.ts";

/** Whether the solver came; where it did not, the problem has been said. */
export async function solverIsThere(page: Page): Promise<boolean> {
  try {
    await client(page).ready;
    return true;
  } catch (error) {
    say(page, sentence(error));
    page.stranded.value = true;
    return false;
  }
}

export type ChangesListener = (changes: Float32Array) => void;

const listeners = kept(() => new Set<ChangesListener>());

/** Calls `listener` with vertex, x, y, z (display coordinates) of whatever moves. */
export function onChanges(page: Page, listener: ChangesListener): () => void {
  listeners(page).add(listener);
  return () => listeners(page).delete(listener);
}

export function announceChanges(page: Page, changes: Float32Array): void {
  for (const listener of listeners(page)) listener(changes);
}

/** A mesh as the solver has it open. */
export interface Base {
  readonly source: Source;
  readonly planarised: Planarising | null;
  /** Under which its edits have images. */
  readonly symmetry: Symmetry | null;
  /** Made once it is flat, and symmetric. */
  readonly cuts: readonly string[];
}

/** What a design is an edit of. */
export const baseOf = ({ source, planarised, settings }: BaseSteps): Base => ({
  source,
  planarised,
  symmetry: symmetryIn(settings),
  cuts: settings.cuts,
});

/** What changes its cuts alone. */
export const cutQuestion = ({ symmetry, cuts }: Base) =>
  ({ kind: "cut", cuts, tolerance: symmetry?.tolerance ?? 0 }) as const;

type BaseSteps = Pick<Design, "source" | "planarised" | "settings">;

/** What makes the solver open it. */
export const openQuestion = ({ source, planarised, symmetry, cuts }: Base) =>
  ({ kind: "open", source, planarise: planarised, symmetry, cuts }) as const;

/** What makes a second solver open it, where the points of the mesh after all that are known. */
export const openKnownQuestion = (base: Base, { positions }: Pick<OpenedMesh, "positions">) => {
  const question = openQuestion(base);
  return base.planarised ? { ...question, found: positions.slice() } : question;
};

/** What the solver holds; null where it would have to be told again. */
interface Held {
  base: Base | null;
  /** The shape that its variations were found around. */
  centre: Shape | null;
}

export const held = kept((): Held => ({ base: null, centre: null }));

interface Own {
  recover: () => void;
  running: number;
}

const own = kept((): Own => ({ recover: () => {}, running: 0 }));

/** Calls `action` after the solver died and its replacement was started. */
export function onDeath(page: Page, action: () => void): void {
  own(page).recover = action;
}

function forget(page: Page): void {
  Object.assign(held(page), { base: null, centre: null } satisfies Held);
}

export const client = kept(
  (page) =>
    new SolverClient(page.spawn, {
      progress: (progress) => {
        const { value } = page.activity;
        if (!value) return;
        const { label, step } = value;
        page.activity.value =
          progress.kind === "reading"
            ? { label, step, read: { done: progress.done, total: progress.total } }
            : { label, step: progress.step };
      },
      died: (sentence) => {
        forget(page);
        say(page, sentence);
        own(page).recover();
      },
    }),
);

/** Tells the solver a design that is known, to the last bit. @param keep its variations */
export const restoreQuestion = ({ handles, settings, shape }: Design, keep: boolean) =>
  ({ kind: "restore", targets: toTargets(handles), settings, shape, keep }) as const;

/** Replaces the solver at once; what it did is abandoned. */
export function restartSolver(page: Page): void {
  client(page).cancel();
  forget(page);
}

/** Keeps account of what the solver holds. A refused `open` may have left another mesh behind. */
function account(page: Page, question: Question, answer: Answer | null): void {
  const done = answer !== null;
  const solver = held(page);
  switch (question.kind) {
    case "open":
      solver.base = done ? openedBase(question, answer) : null;
      solver.centre = null;
      return;
    case "planarise":
      if (done && solver.base)
        solver.base = { ...solver.base, planarised: question.how, symmetry: null };
      if (done) solver.centre = null;
      return;
    case "cut":
      if (done && solver.base) solver.base = { ...solver.base, cuts: question.cuts };
      solver.centre = null;
      return;
    case "restore":
      if (done && !question.keep) solver.centre = null;
      return;
    case "edit":
    case "fewest":
    case "replay":
    case "read":
    case "join":
    case "turn":
      if (done) solver.centre = null;
  }
}

/** The base that was opened, with the symmetry that was found, where any was asked for. */
function openedBase(question: Extract<Question, { kind: "open" }>, answer: Answer): Base {
  const { source, planarise: planarised, symmetry, cuts } = question;
  const elements = (answer.kind === "opened" && answer.mesh.symmetry?.elements) || [];
  return { source, planarised, symmetry: symmetry && { ...symmetry, elements }, cuts };
}

async function ask(page: Page, question: Question): Promise<Answer> {
  try {
    const answer = await client(page).ask(question);
    account(page, question, answer);
    if (answer.kind === "opened" && answer.source)
      held(page).base = { source: answer.source, planarised: null, symmetry: null, cuts: [] };
    return answer;
  } catch (error) {
    account(page, question, null);
    throw error;
  }
}

function show(page: Page, answer: Answer): void {
  if (answer.kind !== "shown" && answer.kind !== "replayed") return;
  announceChanges(page, answer.changes);
  page.figures.value = answer.report;
}

type AnswerTo<K extends Answer["kind"]> = Extract<Answer, { kind: K }>;

const asking =
  (visibly: boolean) =>
  async <K extends Answer["kind"]>(
    page: Page,
    label: string,
    question: Question,
    kind: K,
  ): Promise<Result<AnswerTo<K>>> => {
    own(page).running += 1;
    page.activity.value = { label, step: 0 };
    try {
      const answer = await ask(page, question);
      if (visibly) show(page, answer);
      return answer.kind === kind ? done(answer as AnswerTo<K>) : GIVEN_UP;
    } catch (error) {
      return refusalOf(error);
    } finally {
      own(page).running -= 1;
      if (own(page).running === 0) page.activity.value = null;
    }
  };

/** Asks and shows what comes back; refused, nothing has changed. */
export const run = asking(true);

/** run() without showing: for steps on the way to what will be shown. */
export const runUnseen = asking(false);

/**
 * Tells a new solver what is on screen already, before anything else is asked of it; nobody has to
 * wait for that to be shown.
 */
export const tell = (page: Page, ...questions: readonly Question[]): Promise<Result<unknown>> =>
  Promise.all(questions.map((question) => ask(page, question))).then(done, refusalOf);

/**
 * A frame of a drag or a slider. Overtaken frames are dropped; a refused one keeps the frame
 * before it on screen, and what ends the drag says why if it is refused too.
 */
export async function frame(page: Page, question: Question): Promise<Answer | null> {
  try {
    const answer = await client(page).stream(question);
    account(page, question, answer);
    show(page, answer);
    say(page, null);
    return answer;
  } catch {
    return null; // The last good frame stays.
  }
}

const sentence = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

/** What to say of an error; of a solver that stopped, its death is said. */
const refusalOf = (error: unknown): Refusal =>
  error instanceof Abandoned || error instanceof Died ? GIVEN_UP : refuse(sentence(error));

// SPDX-License-Identifier: MIT
// The one solver of the page, and what its answers do to the state.
import { Abandoned, type Answer, Died, type Question, SolverClient } from "../solver/client.ts";
import type { Planarising, Shape, Source } from "../solver/protocol.ts";
import { spawnSolver } from "../solver/spawn.ts";
import { activity, figures, measurable, problem, stranded } from "./store.ts";

/** Whether the solver came; where it did not, the problem has been said. */
export async function solverIsThere(): Promise<boolean> {
  try {
    await client.ready;
    return true;
  } catch (error) {
    problem.value = sentence(error);
    stranded.value = true;
    return false;
  }
}

export type ChangesListener = (changes: Float32Array) => void;

const listeners = new Set<ChangesListener>();

/** Calls `listener` with vertex, x, y, z (display coordinates) of whatever moves. */
export function onChanges(listener: ChangesListener): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

export function announceChanges(changes: Float32Array): void {
  for (const listener of listeners) listener(changes);
}

/** A mesh as the solver has it open. */
export interface Base {
  readonly source: Source;
  readonly planarised: Planarising | null;
}

/** What the solver holds; null where it would have to be told again. */
interface Held {
  base: Base | null;
  /** The shape that its variations were found around. */
  centre: Shape | null;
}

export const held: Held = { base: null, centre: null };

let recover: () => void = () => {};

/** Calls `action` after the solver died and its replacement was started. */
export function onDeath(action: () => void): void {
  recover = action;
}

function forget(): void {
  held.base = null;
  held.centre = null;
}

export const client = new SolverClient(spawnSolver, {
  progress: (progress) => {
    const { value } = activity;
    if (!value) return;
    const { label, step } = value;
    activity.value =
      progress.kind === "reading"
        ? { label, step, read: { done: progress.done, total: progress.total } }
        : { label, step: progress.step };
  },
  measurable: () => {
    measurable.value += 1;
  },
  died: (sentence) => {
    forget();
    problem.value = sentence;
    recover();
  },
});

/** Replaces the solver at once; what it did is abandoned. */
export function restartSolver(): void {
  client.cancel();
  forget();
}

/** Keeps account of what the solver holds. A refused `open` may have left another mesh behind. */
function account(question: Question, done: boolean): void {
  switch (question.kind) {
    case "open":
      held.base = done ? { source: question.source, planarised: question.planarise } : null;
      held.centre = null;
      return;
    case "planarise":
      if (done && held.base) held.base = { ...held.base, planarised: question.how };
      if (done) held.centre = null;
      return;
    case "restore":
      if (done && !question.keep) held.centre = null;
      return;
    case "edit":
    case "replay":
    case "read":
      if (done) held.centre = null;
  }
}

async function ask(question: Question): Promise<Answer> {
  try {
    const answer = await client.ask(question);
    account(question, true);
    if (answer.kind === "opened" && answer.source)
      held.base = { source: answer.source, planarised: null };
    return answer;
  } catch (error) {
    account(question, false);
    throw error;
  }
}

function show(answer: Answer): void {
  if (answer.kind !== "shown" && answer.kind !== "replayed") return;
  announceChanges(answer.changes);
  figures.value = answer.report;
}

let running = 0;

type AnswerTo<K extends Answer["kind"]> = Extract<Answer, { kind: K }>;

async function attempt<K extends Answer["kind"]>(
  label: string,
  question: Question,
  kind: K,
  visibly: boolean,
): Promise<AnswerTo<K> | null> {
  running += 1;
  activity.value = { label, step: 0 };
  try {
    const answer = await ask(question);
    if (visibly) show(answer);
    problem.value = null;
    return answer.kind === kind ? (answer as AnswerTo<K>) : null;
  } catch (error) {
    if (!(error instanceof Abandoned || error instanceof Died)) problem.value = sentence(error);
    return null;
  } finally {
    running -= 1;
    if (running === 0) activity.value = null;
  }
}

/** Asks, shows what comes back, and says in words what went wrong; null if nothing changed. */
export const run = <K extends Answer["kind"]>(
  label: string,
  question: Question,
  kind: K,
): Promise<AnswerTo<K> | null> => attempt(label, question, kind, true);

/** The same without showing: for steps on the way to what will be shown. */
export const runUnseen = <K extends Answer["kind"]>(
  label: string,
  question: Question,
  kind: K,
): Promise<AnswerTo<K> | null> => attempt(label, question, kind, false);

/**
 * Tells a new solver what is on screen already, before anything else is asked of it; nobody has to
 * wait for that to be shown. False if it could not be done; then the problem has been said.
 */
export async function tell(...questions: readonly Question[]): Promise<boolean> {
  try {
    await Promise.all(questions.map(ask));
    return true;
  } catch (error) {
    if (!(error instanceof Abandoned || error instanceof Died)) problem.value = sentence(error);
    return false;
  }
}

/**
 * A frame of a drag or a slider. Overtaken frames are dropped; a refused one keeps the frame
 * before it on screen, and what ends the drag says why if it is refused too.
 */
export async function frame(question: Question): Promise<Answer | null> {
  try {
    const answer = await client.stream(question);
    account(question, true);
    show(answer);
    problem.value = null;
    return answer;
  } catch {
    return null; // The last good frame stays.
  }
}

const sentence = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

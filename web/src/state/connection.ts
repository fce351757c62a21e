// SPDX-License-Identifier: MIT
// The one solver of the page, and what its answers do to the state.
import { Abandoned, type Answer, type Question, SolverClient } from "../solver/client.ts";
import { spawnSolver } from "../solver/spawn.ts";
import { activity, figures, problem } from "./store.ts";

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

export const client = new SolverClient(spawnSolver, (step) => {
  if (activity.value) activity.value = { ...activity.value, step };
});

function apply(answer: Answer): void {
  if (answer.kind !== "shown") return;
  announceChanges(answer.changes);
  figures.value = answer.report;
}

let running = 0;

/** Asks, shows what comes back, and says in words what went wrong; null if nothing changed. */
export async function run<K extends Answer["kind"]>(
  label: string,
  question: Question,
  kind: K,
): Promise<Extract<Answer, { kind: K }> | null> {
  running += 1;
  activity.value = { label, step: 0 };
  try {
    const answer = await client.ask(question);
    apply(answer);
    problem.value = null;
    return answer.kind === kind ? (answer as Extract<Answer, { kind: K }>) : null;
  } catch (error) {
    if (!(error instanceof Abandoned)) problem.value = sentence(error);
    return null;
  } finally {
    running -= 1;
    if (running === 0) activity.value = null;
  }
}

/**
 * A frame of a drag or a slider. Overtaken frames are dropped; a refused one keeps the frame
 * before it on screen, and what ends the drag says why if it is refused too.
 */
export async function frame(question: Question): Promise<void> {
  try {
    apply(await client.stream(question));
    problem.value = null;
  } catch {
    // The last good frame stays.
  }
}

const sentence = (error: unknown): string =>
  error instanceof Error ? error.message : String(error);

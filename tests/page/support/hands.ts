// SPDX-License-Identifier: MIT
// What a person does to an element, as the events that a browser makes of it.

type Modifier = "Alt" | "Control" | "Meta" | "Shift" | "ControlOrMeta";

export interface ClickKeys {
  readonly modifiers?: readonly Modifier[];
  readonly force?: boolean;
  readonly position?: { readonly x: number; readonly y: number };
}

const FOCUSABLE = "button, input, select, textarea, a[href], summary, [tabindex]";

/** What fields held when they took the focus: leaving one tells that it was changed. */
const before = new WeakMap<Element, string>();

function tellChange(field: HTMLInputElement): void {
  if (before.get(field) === undefined || before.get(field) === field.value) return;
  before.set(field, field.value);
  field.dispatchEvent(new Event("change", { bubbles: true }));
}

const isText = (element: Element | null): element is HTMLInputElement =>
  element instanceof HTMLInputElement && !/^(range|checkbox|radio|button|file)$/.test(element.type);

export function focus(element: Element | null): void {
  const active = document.activeElement;
  if (active === element) return;
  if (isText(active)) tellChange(active);
  if (isText(element)) before.set(element, element.value);
  if (element) (element as HTMLElement).focus();
  else (active as HTMLElement | null)?.blur();
}

/** Keys that are held down. */
const held = new Set<string>();

const keysOf = (modifiers: readonly string[]) => {
  const down = (...names: string[]): boolean =>
    names.some((name) => modifiers.includes(name) || held.has(name));
  return {
    altKey: down("Alt"),
    ctrlKey: down("Control", "ControlOrMeta"),
    metaKey: down("Meta"),
    shiftKey: down("Shift"),
  };
};

/** Those held now, for events of the pointer. */
export const heldKeys = () => keysOf([]);

/** A popover closes when something outside of it is used. */
function closePopovers(element: Element): void {
  for (const open of document.querySelectorAll<HTMLElement>("[data-popover-open]"))
    if (!open.contains(element)) open.hidePopover();
}

export function click(element: Element, { modifiers = [] }: ClickKeys): void {
  const init = { bubbles: true, cancelable: true, button: 0, ...keysOf(modifiers) };
  const target = element.closest("[popovertarget]");
  const id = target?.getAttribute("popovertarget");
  const menu = id ? document.getElementById(id) : null;
  const wasOpen = menu?.hasAttribute("data-popover-open") ?? false;
  element.dispatchEvent(new PointerEvent("pointerdown", init));
  closePopovers(element);
  if (element.dispatchEvent(new MouseEvent("mousedown", init))) focus(element.closest(FOCUSABLE));
  element.dispatchEvent(new PointerEvent("pointerup", init));
  element.dispatchEvent(new MouseEvent("mouseup", init));
  element.dispatchEvent(new MouseEvent("click", { ...init, detail: 1 }));
  if (menu && !wasOpen) menu.showPopover();
}

export function hover(element: Element): void {
  for (const type of ["pointerover", "mouseover", "pointermove", "mousemove"])
    element.dispatchEvent(new PointerEvent(type, { bubbles: true }));
  for (const type of ["pointerenter", "mouseenter"])
    element.dispatchEvent(new PointerEvent(type, { bubbles: false }));
}

/** Puts a value into a field as if it were typed at once. */
export function enter(field: HTMLInputElement, value: string): void {
  focus(field);
  field.value = value;
  field.dispatchEvent(new Event("input", { bubbles: true }));
  if (field.type === "range") field.dispatchEvent(new Event("change", { bubbles: true }));
}

function spell(chord: string): { key: string; modifiers: string[] } {
  const parts = chord === "+" ? ["+"] : chord.split("+");
  return { key: parts.at(-1) ?? "", modifiers: parts.slice(0, -1) };
}

const NAMED: Readonly<Record<string, string>> = { Space: " " };

const codeOf = (key: string): string =>
  /^[a-z]$/i.test(key) ? `Key${key.toUpperCase()}` : /^\d$/.test(key) ? `Digit${key}` : key;

function send(type: "keydown" | "keyup", key: string, modifiers: readonly string[]): boolean {
  const init = { key: NAMED[key] ?? key, code: codeOf(key), ...keysOf(modifiers) };
  const target = document.activeElement ?? document.body;
  return target.dispatchEvent(
    new KeyboardEvent(type, { bubbles: true, cancelable: true, ...init }),
  );
}

const STEPS: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
};

/** A slider goes a step, held within its ends. */
function slide(slider: HTMLInputElement, key: string): void {
  const [step, min, max] = [slider.step, slider.min, slider.max].map(Number);
  const ends: Readonly<Record<string, number | undefined>> = { Home: min, End: max };
  const way = STEPS[key];
  const wished = way === undefined ? ends[key] : Number(slider.value) + way * (step ?? 1);
  if (wished === undefined) return;
  const digits = slider.step.split(".")[1]?.length ?? 0;
  const value = Math.min(Math.max(wished, min ?? 0), max ?? 100).toFixed(digits);
  if (Number(value) === Number(slider.value)) return;
  enter(slider, String(Number(value)));
}

function closeTop(): void {
  const open = [...document.querySelectorAll<HTMLElement>("[data-popover-open]")].at(-1);
  if (open) {
    open.hidePopover();
    return;
  }
  const dialog = [...document.querySelectorAll<HTMLDialogElement>("dialog[open]")].at(-1);
  dialog?.close();
}

function submit(field: HTMLInputElement): void {
  tellChange(field);
  const button = field.form?.querySelector<HTMLButtonElement>("button:not([type=button])");
  if (button) click(button, {});
  else field.form?.dispatchEvent(new Event("submit", { bubbles: true, cancelable: true }));
}

function typeLetter(field: HTMLInputElement, letter: string): void {
  field.value += letter;
  field.dispatchEvent(new Event("input", { bubbles: true }));
}

/** What a browser does of itself when a key goes down and nobody takes it. */
function usual(key: string, modified: boolean): void {
  const active = document.activeElement;
  if (key === "Escape") closeTop();
  else if (active instanceof HTMLInputElement && active.type === "range") slide(active, key);
  else if (isText(active)) {
    if (key === "Enter") submit(active);
    else if (key.length === 1 && !modified) typeLetter(active, key);
  } else if (key === "Enter" && active?.matches("button, a, summary")) click(active, {});
}

export function keyDown(chord: string, modifiers: readonly string[] = []): void {
  const taken = !send("keydown", chord, modifiers);
  held.add(chord);
  const { ctrlKey, altKey, metaKey } = keysOf(modifiers);
  if (!taken) usual(chord, ctrlKey || altKey || metaKey);
}

export function keyUp(chord: string, modifiers: readonly string[] = []): void {
  held.delete(chord);
  const active = document.activeElement;
  const taken = !send("keyup", chord, modifiers);
  const pressed = chord === "Space" || chord === " ";
  if (!taken && pressed && active?.matches("button, summary, input[type=checkbox]"))
    click(active, {});
}

/** "Control+Shift+z", "Enter", "+". */
export function pressKey(chord: string): void {
  const { key, modifiers } = spell(chord);
  keyDown(key, modifiers);
  keyUp(key, modifiers);
}

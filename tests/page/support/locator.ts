// SPDX-License-Identifier: MIT
// Finds elements by what people know them by, and waits for them: as much of Playwright's Locator as the
// tests use, over a document in this process.
import { PATIENCE } from "../../patience.ts";
import {
  elementsIn,
  isDisabled,
  isOfRole,
  isShown,
  isTold,
  labelsOf,
  nameOf,
  oneLine,
  shownText,
} from "./aria.ts";
import { type ClickKeys, click, enter, focus, hover, pressKey } from "./hands.ts";
import { boxOf } from "./view.ts";

type Words = string | RegExp;

interface RoleOptions {
  readonly name?: Words;
  readonly exact?: boolean;
  readonly pressed?: boolean;
  readonly checked?: boolean;
  readonly expanded?: boolean;
  readonly selected?: boolean;
  readonly disabled?: boolean;
  readonly includeHidden?: boolean;
}

interface FilterOptions {
  readonly has?: LocatorHere;
  readonly hasText?: Words;
  readonly visible?: boolean;
}

/** What an option of a list is chosen by. */
interface Choice {
  readonly label?: string;
  readonly value?: string;
  readonly index?: number;
}

type Query = () => Element[];

export const turn = (milliseconds = 0): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Asks until the answer is not null; throws `what` after a while. */
export async function until<T>(
  ask: () => T | null,
  what: () => string,
  timeout = PATIENCE,
): Promise<T> {
  // Looking through the document takes the time of a solver in the same process: less often by and by.
  for (let [end, pause] = [Date.now() + timeout, 5]; ; pause = Math.min(2 * pause, 80)) {
    const found = ask();
    if (found !== null) return found;
    if (Date.now() > end) throw new Error(what());
    await turn(pause);
  }
}

const matches = (text: string, words: Words, exact = false): boolean => {
  const line = oneLine(text);
  if (words instanceof RegExp) return words.test(line);
  const wanted = oneLine(words);
  return exact ? line === wanted : line.toLowerCase().includes(wanted.toLowerCase());
};

const unique = (elements: readonly Element[]): Element[] =>
  [...new Set(elements)].sort((a, b) =>
    a.compareDocumentPosition(b) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1,
  );

const stated = (element: Element, name: string): boolean =>
  element.getAttribute(`aria-${name}`) === "true";

const isChecked = (element: Element): boolean =>
  (element as HTMLInputElement).checked ?? stated(element, "checked");

function hasRole(element: Element, role: string, options: RoleOptions): boolean {
  if (!isOfRole(element, role)) return false;
  const { name, exact, pressed, checked, expanded, selected, disabled } = options;
  if (pressed !== undefined && stated(element, "pressed") !== pressed) return false;
  if (checked !== undefined && isChecked(element) !== checked) return false;
  if (expanded !== undefined && stated(element, "expanded") !== expanded) return false;
  if (selected !== undefined && stated(element, "selected") !== selected) return false;
  if (disabled !== undefined && isDisabled(element) !== disabled) return false;
  if (name !== undefined && !matches(nameOf(element), name, exact)) return false;
  return options.includeHidden || isTold(element);
}

const isSkipped = ({ tagName }: Element): boolean => /^(SCRIPT|STYLE|NOSCRIPT)$/.test(tagName);

/** The innermost elements whose text is so. A DOM puts the text of each together from all that it holds:
 * here that of the parts, whose texts are known. */
function withText(root: Element, words: Words, exact: boolean): Element[] {
  const found: Element[] = [];
  const walk = (node: Node): { text: string; inside: boolean } => {
    if (!(node instanceof Element)) {
      return {
        text: node.nodeType === Node.TEXT_NODE ? (node.textContent ?? "") : "",
        inside: false,
      };
    }
    if (isSkipped(node)) return { text: node.textContent ?? "", inside: false };
    const parts = [...node.childNodes].map(walk);
    const text = parts.map((part) => part.text).join("");
    if (parts.some((part) => part.inside)) return { text, inside: true };
    const inside = matches(text, words, exact);
    if (inside) found.push(node);
    return { text, inside };
  };
  walk(root);
  return found;
}

function css(root: Element, selector: string): Element[] {
  if (selector === "..") return root.parentElement ? [root.parentElement] : [];
  if (selector.startsWith("xpath=")) return byPath(root, selector.slice("xpath=".length));
  return [...root.querySelectorAll(selector.replaceAll(":popover-open", "[data-popover-open]"))];
}

/** following-sibling::tag and ../tag. */
function byPath(root: Element, path: string): Element[] {
  const [, tag = "*"] = /(?:following-sibling::|\.\.\/)(\w+)$/.exec(path) ?? [];
  const all = [...(root.parentElement?.children ?? [])];
  const among = path.startsWith("..") ? all : all.slice(all.indexOf(root) + 1);
  return among.filter((element) => element.tagName.toLowerCase() === tag);
}

export class LocatorHere {
  readonly #query: Query;
  readonly #name: string;

  constructor(query: Query, name: string) {
    this.#query = query;
    this.#name = name;
  }

  elements(): Element[] {
    return this.#query();
  }

  #below(name: string, find: (root: Element) => readonly Element[]): LocatorHere {
    return new LocatorHere(() => {
      const roots = this.#query();
      const found = roots.flatMap((root) => [...find(root)]);
      return roots.length === 1 ? found : unique(found);
    }, `${this.#name} ${name}`);
  }

  #which(name: string, choose: (all: Element[]) => Element[]): LocatorHere {
    return new LocatorHere(() => choose(this.#query()), `${this.#name} ${name}`);
  }

  getByRole(role: string, options: RoleOptions = {}): LocatorHere {
    return this.#below(`${role} ${String(options.name ?? "")}`, (root) =>
      elementsIn(root).filter((element) => hasRole(element, role, options)),
    );
  }

  getByText(words: Words, { exact = false } = {}): LocatorHere {
    return this.#below(`text ${String(words)}`, (root) => withText(root, words, exact));
  }

  getByLabel(words: Words, { exact = false } = {}): LocatorHere {
    const labelled = (element: Element): boolean => {
      const named = element.hasAttribute("aria-label") || element.hasAttribute("aria-labelledby");
      return (named || labelsOf(element).length > 0) && matches(nameOf(element), words, exact);
    };
    return this.#below(`label ${String(words)}`, (root) => elementsIn(root).filter(labelled));
  }

  getByTitle(words: Words, { exact = false } = {}): LocatorHere {
    return this.#below(`title ${String(words)}`, (root) =>
      [...root.querySelectorAll("[title]")].filter((element) =>
        matches(element.getAttribute("title") ?? "", words, exact),
      ),
    );
  }

  locator(selector: string, options: FilterOptions = {}): LocatorHere {
    return this.#below(selector, (root) => css(root, selector)).filter(options);
  }

  filter({ has, hasText, visible }: FilterOptions): LocatorHere {
    return this.#which("filtered", (all) => {
      const inner = has ? has.elements() : [];
      return all.filter(
        (element) =>
          (!has || inner.some((one) => one !== element && element.contains(one))) &&
          (hasText === undefined || matches(element.textContent ?? "", hasText)) &&
          (visible === undefined || isShown(element) === visible),
      );
    });
  }

  and(other: LocatorHere): LocatorHere {
    return this.#which("and", (all) => all.filter((one) => other.elements().includes(one)));
  }

  or(other: LocatorHere): LocatorHere {
    return this.#which("or", (all) => unique([...all, ...other.elements()]));
  }

  first(): LocatorHere {
    return this.nth(0);
  }

  last(): LocatorHere {
    return this.nth(-1);
  }

  nth(k: number): LocatorHere {
    return this.#which(`#${k}`, (all) => [all.at(k)].flatMap((one) => one ?? []));
  }

  async count(): Promise<number> {
    return this.#query().length;
  }

  async all(): Promise<LocatorHere[]> {
    return this.#query().map((_, k) => this.nth(k));
  }

  /** The only one, once it is there and `is` so; a test that means one of several says which. */
  async #one(is: (element: Element) => boolean, what: string): Promise<Element> {
    return until(
      () => {
        const [element, other] = this.#query();
        if (other) throw new Error(`${this.#name}: there are several`);
        return element && is(element) ? element : null;
      },
      () => `${this.#name}: not ${what}`,
    );
  }

  #there(): Promise<Element> {
    return this.#one(() => true, "there");
  }

  #usable(): Promise<Element> {
    return this.#one((element) => isShown(element) && !isDisabled(element), "usable");
  }

  async waitFor({ state = "visible", timeout = PATIENCE } = {}): Promise<void> {
    const isSo: Readonly<Record<string, () => boolean>> = {
      attached: () => this.#query().length > 0,
      detached: () => this.#query().length === 0,
      hidden: () => !this.#query().some(isShown),
      visible: () => this.#query().some(isShown),
    };
    await until(
      () => (isSo[state]?.() ? true : null),
      () => `${this.#name}: not ${state}`,
      timeout,
    );
  }

  async click(how: ClickKeys = {}): Promise<void> {
    click(await this.#usable(), how);
    await turn();
  }

  async dblclick(): Promise<void> {
    const element = await this.#usable();
    click(element, {});
    click(element, {});
    element.dispatchEvent(new MouseEvent("dblclick", { bubbles: true }));
    await turn();
  }

  async hover(): Promise<void> {
    hover(await this.#one(isShown, "visible"));
    await turn();
  }

  async fill(value: string): Promise<void> {
    enter((await this.#usable()) as HTMLInputElement, value);
    await turn();
  }

  async press(key: string): Promise<void> {
    focus(await this.#usable());
    pressKey(key);
    await turn();
  }

  async focus(): Promise<void> {
    focus(await this.#one(isShown, "visible"));
    await turn();
  }

  async blur(): Promise<void> {
    ((await this.#there()) as HTMLElement).blur();
    await turn();
  }

  async setChecked(wanted: boolean): Promise<void> {
    const element = await this.#usable();
    if (isChecked(element) !== wanted) click(element, {});
    await turn();
  }

  check = (): Promise<void> => this.setChecked(true);
  uncheck = (): Promise<void> => this.setChecked(false);

  async selectOption(wanted: string | Choice): Promise<void> {
    const select = (await this.#usable()) as HTMLSelectElement;
    const { label, value, index }: Choice =
      typeof wanted === "string" ? { label: wanted, value: wanted } : wanted;
    const isIt = (option: HTMLOptionElement, k: number): boolean =>
      k === index || oneLine(option.textContent ?? "") === label || option.value === value;
    const option = await until(
      () => [...select.querySelectorAll("option")].find(isIt) ?? null,
      () => `${this.#name}: no option ${label ?? value ?? index}`,
    );
    select.value = option.value;
    for (const type of ["input", "change"])
      select.dispatchEvent(new Event(type, { bubbles: true }));
    await turn();
  }

  async dispatchEvent(type: string, init: EventInit = {}): Promise<void> {
    (await this.#there()).dispatchEvent(
      new Event(type, { bubbles: true, cancelable: true, ...init }),
    );
    await turn();
  }

  async textContent(): Promise<string> {
    return (await this.#there()).textContent ?? "";
  }

  async innerText(): Promise<string> {
    return shownText(await this.#there());
  }

  async allTextContents(): Promise<string[]> {
    return this.#query().map((element) => element.textContent ?? "");
  }

  async allInnerTexts(): Promise<string[]> {
    return this.#query().map(shownText);
  }

  async inputValue(): Promise<string> {
    return ((await this.#there()) as HTMLInputElement).value;
  }

  async getAttribute(name: string): Promise<string | null> {
    return (await this.#there()).getAttribute(name);
  }

  async isVisible(): Promise<boolean> {
    return this.#query().some(isShown);
  }

  async isHidden(): Promise<boolean> {
    return !(await this.isVisible());
  }

  async isDisabled(): Promise<boolean> {
    return isDisabled(await this.#there());
  }

  async isEnabled(): Promise<boolean> {
    return !isDisabled(await this.#there());
  }

  async isChecked(): Promise<boolean> {
    return isChecked(await this.#there());
  }

  async boundingBox() {
    return boxOf(await this.#there());
  }

  async evaluate<A, T>(ask: (element: Element, given: A) => T, given: A): Promise<Awaited<T>> {
    return await ask(await this.#there(), given);
  }

  async evaluateAll<A, T>(
    ask: (elements: Element[], given: A) => T,
    given: A,
  ): Promise<Awaited<T>> {
    return await ask(this.#query(), given);
  }
}

// SPDX-License-Identifier: MIT
// What assistive technology would be told of an element: its role, its name, and whether it is there at all.
// As much of WAI-ARIA as the page uses.
import { PropertySymbol } from "happy-dom";

interface Holding {
  readonly [PropertySymbol.elementArray]: readonly Element[];
}

/** All elements in it, in their order: what the selector `*` finds, in a tenth of its time. */
export function elementsIn(root: Element): Element[] {
  const found: Element[] = [];
  const walk = (node: Element): void => {
    for (const child of (node as unknown as Holding)[PropertySymbol.elementArray]) {
      found.push(child);
      walk(child);
    }
  };
  walk(root);
  return found;
}

const INPUT_ROLES: Readonly<Record<string, string>> = {
  button: "button",
  checkbox: "checkbox",
  number: "spinbutton",
  radio: "radio",
  range: "slider",
  search: "searchbox",
  text: "textbox",
};

const TAG_ROLES: Readonly<Record<string, string>> = {
  ARTICLE: "article",
  ASIDE: "complementary",
  BUTTON: "button",
  CAPTION: "caption",
  DD: "definition",
  DETAILS: "group",
  DIALOG: "dialog",
  DT: "term",
  FIELDSET: "group",
  H1: "heading",
  H2: "heading",
  H3: "heading",
  HEADER: "banner",
  IMG: "img",
  LI: "listitem",
  MAIN: "main",
  NAV: "navigation",
  OL: "list",
  OPTION: "option",
  OUTPUT: "status",
  SELECT: "combobox",
  TABLE: "table",
  TBODY: "rowgroup",
  TD: "cell",
  TEXTAREA: "textbox",
  THEAD: "rowgroup",
  TR: "row",
  UL: "list",
};

/** Tags that alone can have a role which nothing says. */
const tagsOf = new Map<string, Set<string>>([
  ["link", new Set(["A"])],
  ["rowheader", new Set(["TH"])],
  ["columnheader", new Set(["TH"])],
  ["region", new Set(["SECTION"])],
]);
for (const [tag, role] of [
  ...Object.entries(TAG_ROLES),
  ...Object.values(INPUT_ROLES).map((role) => ["INPUT", role] as const),
])
  tagsOf.set(role, (tagsOf.get(role) ?? new Set()).add(tag));

/** Whether a role is an element's; most are told by their tag that it is not. */
export const isOfRole = (element: Element, role: string): boolean =>
  tagsOf.get(role)?.has(element.tagName)
    ? roleOf(element) === role
    : element.getAttribute("role") === role;

function roleOf(element: Element): string | null {
  const said = element.getAttribute("role");
  if (said) return said;
  if (element instanceof HTMLInputElement) return INPUT_ROLES[element.type] ?? null;
  if (element.tagName === "A") return element.hasAttribute("href") ? "link" : null;
  if (element.tagName === "TH")
    return element.getAttribute("scope") === "row" ? "rowheader" : "columnheader";
  if (element.tagName === "SECTION") return nameOf(element) ? "region" : null;
  return TAG_ROLES[element.tagName] ?? null;
}

/** Roles that are named by what they hold. */
const NAMED_BY_CONTENT = new Set([
  "button",
  "cell",
  "checkbox",
  "columnheader",
  "heading",
  "link",
  "option",
  "row",
  "rowheader",
  "tab",
]);

export const oneLine = (text: string): string => text.replace(/\s+/g, " ").trim();

const BLOCK =
  /^(DIV|P|DT|DD|LI|TD|TH|TR|H\d|UL|OL|DL|SECTION|FIELDSET|LEGEND|BUTTON|LABEL|SUMMARY)$/;

/** The text of an element as it is read aloud. */
function spoken(node: Node): string {
  if (node.nodeType === Node.TEXT_NODE) return node.textContent ?? "";
  if (!(node instanceof Element) || isOff(node)) return "";
  const label = node.getAttribute("aria-label");
  if (label) return label;
  const inner = [...node.childNodes].map(spoken).join("");
  return BLOCK.test(node.tagName) ? ` ${inner} ` : inner;
}

function byId(element: Element, ids: string): string {
  const named = ids.split(/\s+/).map((id) => element.ownerDocument.getElementById(id));
  return named.map((other) => other?.textContent ?? "").join(" ");
}

function ownLabel(element: Element): string | null {
  const { tagName } = element;
  const child = (tag: string): Element | undefined =>
    [...element.children].find((one) => one.tagName === tag);
  if (tagName === "FIELDSET") return child("LEGEND")?.textContent ?? null;
  if (tagName === "TABLE") return child("CAPTION")?.textContent ?? null;
  return element.getAttribute("alt");
}

/** The <label>s of a field. */
export function labelsOf(element: Element): Element[] {
  if (!/^(INPUT|SELECT|TEXTAREA|OUTPUT)$/.test(element.tagName)) return [];
  const around = element.closest("label");
  const { id } = element;
  const away = id ? [...element.ownerDocument.querySelectorAll(`label[for="${id}"]`)] : [];
  return around && !around.hasAttribute("for") ? [around, ...away] : away;
}

/** A label's words without what stands in the field that it is of. */
function labelWords(node: Node): string {
  if (node.nodeType === Node.TEXT_NODE) return node.textContent ?? "";
  if (!(node instanceof Element) || /^(INPUT|SELECT|TEXTAREA)$/.test(node.tagName)) return "";
  return isOff(node) ? "" : [...node.childNodes].map(labelWords).join("");
}

export function nameOf(element: Element): string {
  const ids = element.getAttribute("aria-labelledby");
  if (ids) return oneLine(byId(element, ids));
  const said = element.getAttribute("aria-label");
  if (said) return oneLine(said);
  const labels = labelsOf(element);
  if (labels.length > 0) return oneLine(labels.map(labelWords).join(" "));
  const own = ownLabel(element);
  if (own) return oneLine(own);
  const role = element.tagName === "SECTION" ? null : roleOf(element);
  const content = role && NAMED_BY_CONTENT.has(role) ? [...element.childNodes].map(spoken) : [];
  return oneLine(content.join("") || (element.getAttribute("title") ?? ""));
}

/** Elements that only other sizes or colours of the page show. */
const ELSEWHERE = /(^| )(short-word|dark-only|sheet-fold)( |$)/;

/** Whether it and what it holds is not there for anybody. */
function isGone(element: Element): boolean {
  if (element.hasAttribute("hidden") || ELSEWHERE.test(element.getAttribute("class") ?? ""))
    return true;
  if (element.tagName === "DIALOG") return !element.hasAttribute("open");
  if (element.hasAttribute("popover")) return !element.hasAttribute("data-popover-open");
  if ((element as HTMLElement).style?.display === "none") return true;
  const parent = element.parentElement;
  const folded = parent?.tagName === "DETAILS" && !parent.hasAttribute("open");
  return folded && element.tagName !== "SUMMARY";
}

/** Whether a reader passes over it. */
const isOff = (element: Element): boolean =>
  element.getAttribute("aria-hidden") === "true" || isGone(element);

const within = (element: Element, is: (one: Element) => boolean): boolean => {
  for (let one: Element | null = element; one; one = one.parentElement) if (is(one)) return true;
  return false;
};

export const isShown = (element: Element): boolean =>
  element.isConnected && !within(element, isGone);

/** Whether roles find it. */
export const isTold = (element: Element): boolean => !within(element, isOff);

export function isDisabled(element: Element): boolean {
  if ((element as HTMLButtonElement).disabled) return true;
  return element.closest("fieldset[disabled]") !== null;
}

/** What is written in it and shown, a line a block. */
export function shownText(element: Element): string {
  const walk = (node: Node): string => {
    if (node.nodeType === Node.TEXT_NODE) return (node.textContent ?? "").replace(/\s+/g, " ");
    if (!(node instanceof Element) || isGone(node)) return "";
    const inner = [...node.childNodes].map(walk).join("");
    if (node.tagName === "TD" || node.tagName === "TH") return `${inner.trim()}\t`;
    return BLOCK.test(node.tagName) ? `\n${inner}\n` : inner;
  };
  const lines = [...element.childNodes].map(walk).join("").split("\n");
  return lines
    .map((line) => line.replace(/^ +| +$/g, ""))
    .filter((line) => line !== "")
    .join("\n")
    .trim();
}

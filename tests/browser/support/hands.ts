// SPDX-License-Identifier: MIT
// A quick user: finds things by role and accessible name inside the page and uses them at once,
// without waiting for frames as a real pointer would. For tests of thousands of actions.
import type { Page } from "playwright-core";
import type { Prepare } from "./drawing.ts";

type Role = "button" | "slider" | "checkbox" | "spinbutton" | "combobox";

interface HandyWindow extends Window {
  /** What the page last offered to save. */
  saved: Blob | null;
}

/** Lets exports be read without going through the disk. */
export const catchExports: Prepare = async (context) => {
  await context.addInitScript(() => {
    const page = window as unknown as HandyWindow;
    const make = URL.createObjectURL.bind(URL);
    URL.createObjectURL = (object: Blob | MediaSource): string => {
      if (object instanceof Blob) page.saved = object;
      return make(object);
    };
    const click = HTMLAnchorElement.prototype.click;
    HTMLAnchorElement.prototype.click = function (): void {
      if (!this.download) click.call(this);
    };
  });
};

/** Defines `find(role)` in the page: what can be used now, in the tab that is in sight or after a press on
 * another, with its accessible name. */
const FINDER = `(role) => {
  const selectors = {
    button: "button",
    slider: "input[type=range]",
    checkbox: "input[type=checkbox]",
    spinbutton: "[role=spinbutton]",
    combobox: "select",
  };
  const name = (element) =>
    (element.getAttribute("aria-label") ??
      [...(element.labels ?? [])].map((label) => label.textContent).join(" ")) ||
    (element.textContent ?? "");
  const visible = (element) => {
    const panel = element.closest("[role=tabpanel][hidden]");
    panel?.removeAttribute("hidden");
    const is = element.checkVisibility();
    panel?.setAttribute("hidden", "");
    return is;
  };
  return [...document.querySelectorAll(selectors[role])]
    .filter((element) => !element.disabled && visible(element))
    .map((element) => ({ element, name: name(element).replace(/\\s+/g, " ").trim() }));
}`;

export class Hands {
  readonly #page: Page;

  constructor(page: Page) {
    this.#page = page;
  }

  /** Accessible names of everything of a role that can be used now and is not pressed already. */
  names(role: Role): Promise<string[]> {
    return this.#page.evaluate(`(${FINDER})("${role}")
      .filter(({ element }) => element.getAttribute("aria-pressed") !== "true")
      .map(({ name }) => name)`);
  }

  async press(name: string): Promise<void> {
    await this.#use("button", name, "element.click()");
    await this.settle();
  }

  async fill(role: "slider" | "spinbutton" | "combobox", name: string, value: string, nth = 0) {
    const enter =
      role === "spinbutton"
        ? `element.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }))`
        : `element.dispatchEvent(new Event("change", { bubbles: true }))`;
    const code = `element.value = ${JSON.stringify(value)};
      element.dispatchEvent(new Event("input", { bubbles: true })); ${enter}`;
    await this.#use(role, name, code, nth);
    await this.settle();
  }

  async toggle(name: string, nth: number): Promise<void> {
    await this.#use("checkbox", name, "element.click()", nth);
    await this.settle();
  }

  /** Starts something and cancels it a little later. */
  async pressAndCancel(name: string, after: number): Promise<void> {
    await this.#use("button", name, "element.click()");
    await this.#page.waitForTimeout(after);
    await this.#page.evaluate(
      `(${FINDER})("button").find(({ name }) => name === "Cancel")?.element.click()`,
    );
    await this.settle();
  }

  /** Until nothing runs and everything has been written into the page. */
  async settle(): Promise<void> {
    await this.#page.evaluate(async () => {
      const still = (): boolean =>
        document.querySelector('[data-fetching="0"]') !== null &&
        [...document.querySelectorAll("button")].some(
          (button) => button.textContent === "Cancel" && button.disabled,
        );
      for (let quiet = 0; quiet < 3; ) {
        await new Promise((done) => setTimeout(done, 15));
        quiet = still() ? quiet + 1 : 0;
      }
    });
  }

  async obj(): Promise<string> {
    await this.#page.evaluate(() => {
      (window as unknown as HandyWindow).saved = null;
    });
    await this.#use("button", "Export", "element.click()");
    await this.#use("button", "OBJ", "element.click()");
    await this.#page.waitForFunction(
      () => (window as unknown as HandyWindow).saved !== null,
      null,
      {
        polling: 10,
      },
    );
    await this.settle();
    return this.#page.evaluate(async () => (window as unknown as HandyWindow).saved?.text() ?? "");
  }

  status(): Promise<string> {
    return this.#page.evaluate(() => document.querySelector("[role=status]")?.textContent ?? "");
  }

  alert(): Promise<string> {
    return this.#page.evaluate(() => document.querySelector("[role=alert]")?.textContent ?? "");
  }

  async #use(role: Role, name: string, code: string, nth = 0): Promise<void> {
    const done = await this.#page.evaluate(`(() => {
      const found = (${FINDER})("${role}").filter(({ name }) => name === ${JSON.stringify(name)});
      const element = found[${nth}]?.element;
      if (!element) return false;
      const tab = element.closest("[role=tabpanel][hidden]")?.getAttribute("aria-labelledby");
      if (tab) document.getElementById(tab).click();
      ${code};
      return true;
    })()`);
    if (!done) throw new Error(`There is no ${role} "${name}" to use.`);
  }
}

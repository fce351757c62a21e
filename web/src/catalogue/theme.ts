// SPDX-License-Identifier: MIT
/** Colours of the page as the chart takes them. */
export interface Theme {
  readonly ink: string;
  readonly quiet: string;
  readonly accent: string;
  readonly surface: string;
}

/** light-dark() is resolved by the browser only where it is used. */
function resolve(name: string): string {
  const probe = document.createElement("span");
  probe.style.color = `var(${name})`;
  document.body.append(probe);
  const { color } = getComputedStyle(probe);
  probe.remove();
  return color;
}

export const currentTheme = (): Theme => ({
  ink: resolve("--ink"),
  quiet: resolve("--ink-2"),
  accent: resolve("--accent"),
  surface: resolve("--surface"),
});

export const onThemeChange = (listener: () => void): void =>
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", listener);

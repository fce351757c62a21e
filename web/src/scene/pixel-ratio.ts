// SPDX-License-Identifier: MIT

/** A window may move to a screen with other pixels. Returns how to stop watching. */
export function watchPixelRatio(changed: () => void): () => void {
  const off = new AbortController();
  const watch = (): void => {
    const now = window.matchMedia(`(resolution: ${window.devicePixelRatio}dppx)`);
    const next = (): void => {
      changed();
      watch();
    };
    now.addEventListener("change", next, { once: true, signal: off.signal });
  };
  watch();
  return () => off.abort();
}

// SPDX-License-Identifier: MIT

/** As much of what has been unfolded as there is room for. scrollIntoView would also move the page under a
 * telephone's address bar. */
export function scrollToSection(section: HTMLElement): void {
  const body = section.closest(".inspector-body");
  if (!body) return;
  const [inside, window] = [section.getBoundingClientRect(), body.getBoundingClientRect()];
  const below = Math.min(inside.bottom - window.bottom, inside.top - window.top);
  if (below > 0) body.scrollBy(0, below);
}

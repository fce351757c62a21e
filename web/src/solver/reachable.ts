// SPDX-License-Identifier: MIT

/** A sandboxed frame has an origin of its own, to which every script is a stranger's: no worker is made
 * of it, but one that imports it is. @param url of a worker's script */
export const reachable = (url: string): string =>
  self.origin === "null"
    ? `data:text/javascript,${encodeURIComponent(`import ${JSON.stringify(new URL(url, location.href).href)}`)}`
    : url;

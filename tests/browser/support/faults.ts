// SPDX-License-Identifier: MIT
// Things that go wrong, made to happen: inside the page, inside the solver's worker, in storage.

import type { Page } from "playwright-core";
import type { StoredRecord } from "../../../web/src/design/stored-record.ts";
import type { Prepare } from "./drawing.ts";

interface FaultyWindow extends Window {
  solvers: Worker[];
  /** Kills the solver this many milliseconds after it is given a job of this kind; 0: before it can begin. */
  kill: { kind: string; after: number } | null;
}

/** Keeps hold of the solvers, so that they can be killed as the browser would: without a word. */
export const holdSolvers: Prepare = async (context) => {
  await context.addInitScript(() => {
    const page = window as unknown as FaultyWindow & { Worker: typeof Worker };
    page.solvers = [];
    page.kill = null;
    page.Worker = class extends Worker {
      constructor(...given: ConstructorParameters<typeof Worker>) {
        super(...given);
        page.solvers.push(this);
      }
      override postMessage(message: { kind: string }): void {
        super.postMessage(message);
        if (page.kill?.kind !== message.kind) return;
        const { after } = page.kill;
        page.kill = null;
        // An edit can be over before the page's next turn.
        if (after === 0) this.terminate();
        else setTimeout(() => this.terminate(), after);
      }
    };
  });
};

export const killDuring = (page: Page, kind: string, after: number): Promise<void> =>
  page.evaluate(
    (kill) => {
      (window as unknown as FaultyWindow).kill = kill;
    },
    { kind, after },
  );

export const killNow = (page: Page): Promise<void> =>
  page.evaluate(() => (window as unknown as FaultyWindow).solvers.at(-1)?.terminate());

/** Runs `code` in every solver before its own. */
export const insideSolver =
  (code: string): Prepare =>
  async (context) => {
    await context.route(/\/worker-[\w-]+\.js$/, async (route) => {
      const response = await route.fetch();
      await route.fulfill({ response, body: `${code}\n${await response.text()}` });
    });
  };

/** Memory that cannot grow beyond what a module starts with. */
export const NO_MORE_MEMORY = `WebAssembly.Memory.prototype.grow = () => {
  throw new RangeError("no memory");
};`;

/** Files that come in pieces of 64 KiB, one every 100 ms. */
export const SLOW_DISK = `Blob.prototype.stream = function () {
  let at = 0;
  return new ReadableStream({
    pull: async (controller) => {
      await new Promise((resolve) => setTimeout(resolve, 100));
      const piece = await this.slice(at, at + 65536).arrayBuffer();
      if (piece.byteLength > 0) controller.enqueue(new Uint8Array(piece));
      else controller.close();
      at += 65536;
    },
  });
};`;

export const denyStorage: Prepare = async (context) => {
  await context.addInitScript(() => {
    IDBFactory.prototype.open = () => {
      throw new DOMException("denied", "SecurityError");
    };
  });
};

export const fillStorage: Prepare = async (context) => {
  await context.addInitScript(() => {
    IDBObjectStore.prototype.put = () => {
      throw new DOMException("full", "QuotaExceededError");
    };
  });
};

/** Holds back the database of a page that is loaded with `?slow` for `milliseconds`; `storageCame` then says so. */
export const slowStorage =
  (milliseconds: number): Prepare =>
  async (context) => {
    await context.addInitScript((wait) => {
      if (!location.search.includes("slow")) return;
      const open = IDBFactory.prototype.open;
      IDBFactory.prototype.open = function (...given) {
        const request = open.apply(this, given);
        const set = (listener: (event: Event) => void): void =>
          request.addEventListener("success", (event) =>
            setTimeout(() => {
              listener.call(request, event);
              Object.assign(window, { storageCame: true });
            }, wait),
          );
        Object.defineProperty(request, "onsuccess", { set });
        return request;
      };
    }, milliseconds);
  };

/** The kept records by slot, as text, after each was said to be of `version`, if that is given. */
export const keptRecords = (
  page: Page,
  version: number | null = null,
): Promise<Record<string, string>> =>
  page.evaluate(
    (given) =>
      new Promise<Record<string, string>>((resolve, reject) => {
        const opening = indexedDB.open("planish");
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
          const transaction = opening.result.transaction("designs", "readwrite");
          const found: Record<string, string> = {};
          transaction.objectStore("designs").openCursor().onsuccess = ({ target }) => {
            const cursor = (target as IDBRequest<IDBCursorWithValue | null>).result;
            if (!cursor) return;
            const key = String(cursor.key);
            if (key.startsWith("record:")) {
              const record = { ...cursor.value, ...(given !== null && { version: given }) };
              if (given !== null) cursor.update(record);
              found[key] = JSON.stringify(record, (_, value: unknown) =>
                ArrayBuffer.isView(value) ? [...(value as Float64Array)] : value,
              );
            }
            cursor.continue();
          };
          transaction.oncomplete = () => {
            opening.result.close();
            resolve(found);
          };
        };
      }),
    version,
  );

/** Makes of every kept record what no page has written; gives how many there were. */
export const damageRecords = async (page: Page): Promise<number> =>
  Object.keys(await keptRecords(page, 0)).length;

/** Puts a record into a slot. */
export const putRecord = (page: Page, key: string, record: StoredRecord): Promise<void> =>
  page.evaluate(
    ([to, value]) =>
      new Promise<void>((resolve, reject) => {
        const opening = indexedDB.open("planish");
        opening.onerror = () => reject(opening.error);
        opening.onsuccess = () => {
          const transaction = opening.result.transaction("designs", "readwrite");
          transaction.objectStore("designs").put(value, to);
          transaction.oncomplete = () => {
            opening.result.close();
            resolve();
          };
        };
      }),
    [key, record] as const,
  );

/** Drops a large file on the page, made there: `text` and then `filler` until it has so many bytes. To send it
 * through what drives the browser would take half a minute. */
export async function dropLarge(
  page: Page,
  name: string,
  { text, filler, bytes }: { text: string; filler: string; bytes: number },
): Promise<void> {
  const dataTransfer = await page.evaluateHandle(
    (given) => {
      const transfer = new DataTransfer();
      const more = given.filler.repeat(Math.ceil(given.bytes / given.filler.length));
      transfer.items.add(new File([given.text, more], given.name));
      return transfer;
    },
    { name, text, filler, bytes },
  );
  await page.getByRole("main").dispatchEvent("drop", { dataTransfer });
}

/** A flat roof of n × n quads as OBJ. */
export function flatRoof(n: number): string {
  const lines: string[] = [];
  for (let i = 0; i <= n; ++i) for (let j = 0; j <= n; ++j) lines.push(`v ${j} ${i} ${0.1 * j}`);
  for (let i = 0; i < n; ++i) {
    for (let j = 0; j < n; ++j) {
      const a = i * (n + 1) + j + 1;
      lines.push(`f ${a} ${a + 1} ${a + n + 2} ${a + n + 1}`);
    }
  }
  return `${lines.join("\n")}\n`;
}

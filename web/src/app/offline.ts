// SPDX-License-Identifier: MIT

import { saveNow } from "../features/saving/autosave.ts";
import { enqueue, type Outcome } from "../state/action-queue.ts";
import type { Page } from "../state/page.ts";

/** Changes versions between two actions, once the design is kept. */
function changeTo(page: Page, waiting: ServiceWorker): Outcome {
  return enqueue(page, async () => {
    await saveNow(page);
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    waiting.postMessage("take over");
    return undefined;
  });
}

/** Offers a version that was installed beside the running one. */
function offer(page: Page, registration: ServiceWorkerRegistration): void {
  const { waiting } = registration;
  if (!waiting || !navigator.serviceWorker.controller) return;
  page.update.value = () => void changeTo(page, waiting);
}

/** Keeps the page for use without a network, where the browser allows it. */
export async function keepOffline(page: Page): Promise<void> {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register("./service-worker.js");
    offer(page, registration);
    registration.addEventListener("updatefound", () => {
      registration.installing?.addEventListener("statechange", () => offer(page, registration));
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "visible") registration.update().catch(() => {});
    });
  } catch {
    // A sandboxed frame or a private window: the page works, only not without a network.
  }
}

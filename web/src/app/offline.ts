// SPDX-License-Identifier: MIT
import { saveNow } from "../state/autosave.ts";
import { update } from "../state/store.ts";
import { inTurn } from "../state/turns.ts";

/** Changes versions between two actions, once the design is kept. */
function changeTo(waiting: ServiceWorker): Promise<void> {
  return inTurn(async () => {
    await saveNow();
    navigator.serviceWorker.addEventListener("controllerchange", () => location.reload());
    waiting.postMessage("take over");
  });
}

/** Offers a version that was installed beside the running one. */
function offer(registration: ServiceWorkerRegistration): void {
  const { waiting } = registration;
  if (!waiting || !navigator.serviceWorker.controller) return;
  update.value = () => void changeTo(waiting);
}

/** Keeps the page for use without a network, where the browser allows it. */
export async function keepOffline(): Promise<void> {
  if (!import.meta.env.PROD || !("serviceWorker" in navigator)) return;
  try {
    const registration = await navigator.serviceWorker.register("./service-worker.js");
    offer(registration);
    registration.addEventListener("updatefound", () => {
      registration.installing?.addEventListener("statechange", () => offer(registration));
    });
    document.addEventListener("visibilitychange", () => {
      if (document.visibilityState === "visible") registration.update().catch(() => {});
    });
  } catch {
    // A sandboxed frame or a private window: the page works, only not without a network.
  }
}

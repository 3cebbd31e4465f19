// Registers the service worker that keeps the files of the page, and announces a newer build. Loaded after the page.

// `announce` is called when a newer build has been fetched beside the one that runs.
export async function keep(announce) {
  const container = navigator.serviceWorker;
  // Registration fails in a private window, or where the browser stores nothing for this host: the page works without.
  const registration = await container.register('service_worker.js').catch(() => null);
  if (!registration) return;
  const look = () => registration.waiting && container.controller && announce();
  registration.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', look));
  look();
  // A page may be open for days, so each return to it looks for a newer build.
  addEventListener('visibilitychange', () => document.visibilityState === 'visible' && registration.update().catch(() => {}));
}

// Activates the newer build, unless another page has already done so.
export async function take() {
  const waiting = (await navigator.serviceWorker.getRegistration())?.waiting;
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  waiting.postMessage('take');
}

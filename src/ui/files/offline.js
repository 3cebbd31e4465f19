// Has the browser keep the files of the page (service_worker.js) and tells of a newer build of them. Loaded when the page is there.

// `announce` is called when a newer build has been fetched beside the one that runs.
export async function keep(announce) {
  const container = navigator.serviceWorker;
  // A private window, or a browser that keeps nothing for this host: the page works as it does without.
  const registration = await container.register('service_worker.js').catch(() => null);
  if (!registration) return;
  const look = () => registration.waiting && container.controller && announce();
  registration.addEventListener('updatefound', () => registration.installing?.addEventListener('statechange', look));
  look();
  // A page may be open for days.
  addEventListener('visibilitychange', () => document.visibilityState === 'visible' && registration.update().catch(() => {}));
}

// Goes over to the newer build. Another page may have done so before.
export async function take() {
  const waiting = (await navigator.serviceWorker.getRegistration())?.waiting;
  if (!waiting) return location.reload();
  navigator.serviceWorker.addEventListener('controllerchange', () => location.reload(), { once: true });
  waiting.postMessage('take');
}

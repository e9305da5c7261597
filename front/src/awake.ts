/** A screen that stays lit and has nothing else on it. */

/** Keep the screen from going dark; browsers forget it whenever the page was out of sight. */
export function keepAwake(): void {
  const ask = (): void => {
    if (document.visibilityState === "visible") void navigator.wakeLock?.request("screen").catch(() => undefined);
  };
  document.addEventListener("visibilitychange", ask);
  ask();
}

/** Fill the screen; a browser allows it only in answer to a key or a touch, else nothing happens. */
export function fillScreen(): void {
  if (document.fullscreenEnabled && !document.fullscreenElement) {
    void document.documentElement.requestFullscreen().catch(() => undefined);
  }
}

/** Standing in the world with a headset, where the browser offers that. */

import type { Stage } from "./stage";
import { make } from "./words";

const KIND = "immersive-vr";

/** Whether there is a headset to enter with. */
async function offered(): Promise<boolean> {
  return (await navigator.xr?.isSessionSupported(KIND).catch(() => false)) ?? false;
}

/** What a page does about a headset. */
interface Visit {
  stage: Stage;
  /** Called for each picture of the headset, with the time in ms. */
  frame(now: number): void;
  /** The trigger of a hand was pressed. */
  pressed(): void;
  /** The headset was taken off. */
  left(): void;
}

/** A button that enters and leaves; it stays hidden without a headset. */
export function entrance(visit: Visit): HTMLButtonElement {
  const button = make("button", { type: "button", class: "enter", hidden: "" }, "Enter VR");
  let session: XRSession | null = null;
  const enter = async (): Promise<void> => {
    session = await navigator.xr!.requestSession(KIND, { optionalFeatures: ["local-floor"] });
    button.textContent = "Leave VR";
    session.addEventListener("select", () => visit.pressed());
    session.addEventListener("end", () => {
      session = null;
      button.textContent = "Enter VR";
      visit.stage.comeBack();
      visit.left();
    });
    await visit.stage.immerse(session, (now) => visit.frame(now));
  };
  button.addEventListener("click", () => void (session ? session.end() : enter()));
  void offered().then((yes) => { button.hidden = !yes; });
  return button;
}

/** The entrance of every page: `data-page` says which one it is. */

import "./view.css";
import { monitor } from "./monitor";
import { participant } from "./participant";
import { replay } from "./replay";
import { NoWebGL } from "./stage";
import { trials } from "./trials";
import { say } from "./words";

const PAGES: { [page: string]: (content: never) => void } = { replay, trials, saying, participant, monitor };

function saying({ title, text }: { title: string; text: string }): void {
  document.body.append(say(title, text));
}

try {
  const content = JSON.parse(document.getElementById("content")!.textContent!) as never;
  PAGES[document.body.dataset.page!]!(content);
} catch (fault) {
  if (!(fault instanceof NoWebGL)) throw fault;
  document.body.replaceChildren(say(
    "This browser draws no WebGL",
    "The world is drawn with WebGL 2, which this browser has switched off or does not know. Switch on "
      + "hardware acceleration in its settings, or open this page in a current Firefox, Chromium, Edge "
      + "or Safari.",
  ));
}

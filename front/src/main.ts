/** The entrance of every page: `data-page` says which one it is. */

import "./view.css";
import { monitor } from "./monitor";
import { participant } from "./participant";
import { replay } from "./replay";
import { NoWebGL } from "./stage";
import { trials } from "./trials";
import { NO_WEBGL, say } from "./words";

const PAGES: { [page: string]: (content: never) => void } = { replay, trials, saying, participant, monitor };

function saying({ title, text }: { title: string; text: string }): void {
  document.body.append(say(title, text));
}

try {
  const content = JSON.parse(document.getElementById("content")!.textContent!) as never;
  PAGES[document.body.dataset.page!]!(content);
} catch (fault) {
  if (!(fault instanceof NoWebGL)) throw fault;
  document.body.replaceChildren(say(NO_WEBGL.title, NO_WEBGL.text));
}

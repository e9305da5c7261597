/** Replay: stored trials, scrubbed and played, one or two in step. */

import type { Film } from "./film";
import { Player } from "./player";
import { Reel } from "./reel";
import { VIEWS } from "./stage";
import { make } from "./words";

export function replay(films: Film[]): void {
  const end = Math.max(...films.map((film) => film.end));
  const reels = films.map((film) => new Reel(film, end));
  const player = new Player(reels, end);
  const main = make("main", { class: reels.length > 1 ? "replay two" : "replay" },
    make("h1", {}, document.title),
    make("div", { class: "reels" }, ...reels.map((reel) => reel.element)),
    player.controls, player.log());
  document.body.append(main);
  document.addEventListener("keydown", (event) => {
    const inside = event.target as HTMLElement;
    const typed = inside.matches("select, input[type=radio]") || (inside.matches("button, input") && event.key === " ");
    if (!typed && !event.ctrlKey && !event.metaKey && !event.altKey && player.key(event.key)) event.preventDefault();
  });
  const wish = new URLSearchParams(location.hash.slice(1));
  main.classList.toggle("bare", wish.has("bare"));
  player.look(VIEWS.find((view) => view === wish.get("camera")) ?? "follow");
  player.seek(Number(wish.get("t")) || 0);
  void Promise.all(reels.map((reel) => reel.stage.prepare())).then(() => {
    Object.assign(window, { replay: { seek: (t: number) => player.seek(t), end, player } });
  });
}

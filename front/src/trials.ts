/** The list of a study's trials, from where each is opened, or two side by side. */

import { clock, make } from "./words";

interface Listed {
  trial: number;
  participant: string;
  position: number;
  condition: string;
  route: string;
  status: string;
  duration_s: number | null;
  collisions: number | null;
}

interface TrialList { study: string; title: string; virtual: boolean; masked: boolean; trials: Listed[] }

const HEADS = (masked: boolean): string[] => [
  "Trial", "Participant", "Place", masked ? "Label" : "Condition", "Route", "Status", "Time",
  "Collisions", "Side by side",
];

export function trials(list: TrialList): void {
  const chosen = new Set<number>();
  const both = make("button", { type: "button", disabled: "" }, "Show two side by side");
  both.addEventListener("click", () => location.assign(`/trial/${[...chosen].join("/")}`));
  const rows = list.trials.map((trial) => row(trial, (on) => {
    if (on) chosen.add(trial.trial);
    else chosen.delete(trial.trial);
    both.disabled = chosen.size !== 2;
  }));
  const head = make("tr", {}, ...HEADS(list.masked).map((name) => make("th", { scope: "col" }, name)));
  document.body.append(make("main", { class: "list" },
    make("h1", {}, `Trials of ${list.study}`),
    make("p", {}, list.title, ...(list.virtual ? [" ", make("span", { class: "mark" }, "virtual participants")] : [])),
    make("div", { class: "row" }, both,
      make("p", {}, make("a", { href: "/monitor" }, "Monitor"), " of the trial that is driven now")),
    make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Trials" },
      make("table", {}, make("thead", {}, head), make("tbody", {}, ...rows)))));
}

function row(trial: Listed, choose: (on: boolean) => void): HTMLElement {
  const seen = trial.duration_s !== null || trial.collisions !== null;
  const link = seen ? make("a", { href: `/trial/${trial.trial}` }, `${trial.trial}`) : `${trial.trial}`;
  const box = make("input", { type: "checkbox", "aria-label": `Trial ${trial.trial} side by side` });
  box.addEventListener("change", () => choose(box.checked));
  const time = trial.duration_s === null ? "" : clock(trial.duration_s);
  const cells = [
    trial.participant, `${trial.position}`, trial.condition, trial.route, trial.status, time,
    trial.collisions === null ? "" : `${trial.collisions}`,
  ];
  return make("tr", {}, make("th", { scope: "row" }, link),
    ...cells.map((text, i) => make("td", i === 1 || i > 4 ? { class: "number" } : {}, text)),
    make("td", {}, ...(seen ? [box] : [])));
}

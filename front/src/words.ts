/** Small pieces of a page. */

type Attributes = { [name: string]: string };

export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Attributes = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

/** A page that has nothing but something to say. */
export function say(title: string, text: string): HTMLElement {
  return make("main", { class: "said" }, make("h1", {}, title), make("p", {}, text));
}

/** What somebody reads whose browser cannot draw the world. */
export const NO_WEBGL = {
  title: "This browser draws no WebGL",
  text: "The world is drawn with WebGL 2, which this browser has switched off or does not know. Switch on "
    + "hardware acceleration in its settings, or open this page in a current Firefox, Chromium, Edge "
    + "or Safari.",
};

export function clock(t: number): string {
  const minutes = Math.floor(t / 60);
  return `${minutes}:${(t - 60 * minutes).toFixed(1).padStart(4, "0")}`;
}

/** Put what is to be told into a sentence's {places}. */
export function fill(sentence: string, values: { [name: string]: string | number }): string {
  return sentence.replace(/\{(\w+)\}/g, (place, name: string) => `${values[name] ?? place}`);
}

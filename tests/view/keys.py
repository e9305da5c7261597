"""Keys pressed in a page, as a keyboard presses them."""

from __future__ import annotations

from omnistudy.view.chromium import Tab

CODES = {
    "Tab": 9,
    "Enter": 13,
    " ": 32,
    "End": 35,
    "Home": 36,
    "ArrowLeft": 37,
    "ArrowUp": 38,
    "ArrowRight": 39,
    "ArrowDown": 40,
}
TEXTS = {"Enter": "\r", " ": " "}
FOCUSED = """(() => {
  const one = document.activeElement;
  const label = one.labels?.length ? one.labels[0].textContent : '';
  return (one.getAttribute('aria-label') || label || one.textContent || one.tagName).trim();
})()"""


def press(tab: Tab, key: str) -> None:
    """Press a key and let it go."""
    code = CODES[key] if key in CODES else ord(key.upper())
    text = TEXTS.get(key, key if len(key) == 1 else "")
    named = {"key": key, "windowsVirtualKeyCode": code}
    down = "keyDown" if text else "rawKeyDown"
    tab.ask("Input.dispatchKeyEvent", type=down, text=text, **named)
    tab.ask("Input.dispatchKeyEvent", type="keyUp", **named)


def tabbed(tab: Tab, most: int = 80) -> list[str]:
    """Go from control to control until the first comes again; give what each is called."""
    tab.value("document.activeElement.blur()")
    found: list[str] = []
    for _ in range(most):
        press(tab, "Tab")
        if tab.value("document.activeElement === document.body"):
            break
        if tab.value("(window.met ??= new Set()).has(document.activeElement)"):
            break
        tab.value("(window.met.add(document.activeElement), 0)")
        found.append(tab.value(FOCUSED))
    tab.value("(window.met = new Set(), 0)")
    return found


def go_to(tab: Tab, name: str, most: int = 80) -> None:
    """Press Tab until the control of a name has the focus."""
    for _ in range(most):
        if tab.value(FOCUSED) == name:
            return
        press(tab, "Tab")
    raise AssertionError(f"no control '{name}' is reached by Tab")

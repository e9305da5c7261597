"""People before the participant's page: each answers it in another way."""

from __future__ import annotations

import time
from abc import ABC, abstractmethod
from collections.abc import Callable
from dataclasses import dataclass

from omnistudy.view.chromium import Tab

MOST_KEYS = 60
KEYS = {"Tab": 9, "Enter": 13, " ": 32, "ArrowRight": 39, "ArrowDown": 40, "x": 88}


def press(tab: Tab, key: str, modifiers: int = 0) -> None:
    """Press and release a key."""
    text = {"Enter": "\r", " ": " ", "x": "x"}.get(key, "")
    code = {" ": "Space", "x": "KeyX"}.get(key, key)
    for kind in ("keyDown" if text else "rawKeyDown", "keyUp"):
        tab.ask(
            "Input.dispatchKeyEvent",
            type=kind,
            key=key,
            code=code,
            windowsVirtualKeyCode=KEYS[key],
            modifiers=modifiers,
            **({"text": text} if text and kind == "keyDown" else {}),
        )


class Person(ABC):
    """Takes choices and writes, on a page that is open in a tab."""

    one_switch = False

    def __init__(self, tab: Tab) -> None:
        self.tab = tab

    @abstractmethod
    def take(self, choice: str) -> None:
        """Take what a selector means."""

    @abstractmethod
    def write(self, words: str) -> None:
        """Write into the one field of the page."""

    def active(self, choice: str) -> bool:
        return bool(self.tab.value(f"document.activeElement.matches({choice!r})"))


class Pointing(Person):
    """Knows where things are."""

    def middle(self, choice: str) -> tuple[float, float]:
        self.tab.wait_for(f"document.querySelector({choice!r}) !== null", 20)
        x, y = self.tab.value(
            f"(() => {{const one = document.querySelector({choice!r});"
            "one.scrollIntoView({block: 'nearest'}); const r = one.getBoundingClientRect();"
            "return [r.x + r.width / 2, r.y + r.height / 2]})()"
        )
        return x, y

    def write(self, words: str) -> None:
        self.take(".field :first-child")
        self.tab.wait_for("document.activeElement.matches('.field :first-child')", 20)
        self.tab.ask("Input.insertText", text=words)


class WithMouse(Pointing):
    """Clicks in the middle of things."""

    def take(self, choice: str) -> None:
        x, y = self.middle(choice)
        for kind in ("mousePressed", "mouseReleased"):
            self.tab.ask(
                "Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1
            )


class WithFinger(Pointing):
    """Touches the middle of things."""

    def take(self, choice: str) -> None:
        x, y = self.middle(choice)
        self.tab.ask("Emulation.setTouchEmulationEnabled", enabled=True)
        self.tab.ask("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.tab.ask("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])


class WithKeyboard(Person):
    """Knows Tab, arrows, Enter and Space."""

    def take(self, choice: str) -> None:
        self.tab.wait_for(f"document.querySelector({choice!r}) !== null", 20)
        radio = "radio" in choice
        for _ in range(MOST_KEYS):
            if self.active(choice):
                press(self.tab, " " if "input" in choice else "Enter")
                return
            press(self.tab, "ArrowRight" if radio and self.active("[type=radio]") else "Tab")
        raise AssertionError(f"{choice} is out of the keyboard's reach")

    def write(self, words: str) -> None:
        for _ in range(MOST_KEYS):
            if self.active(".field :first-child"):
                self.tab.ask("Input.insertText", text=words)
                return
            press(self.tab, "Tab")
        raise AssertionError("the field is out of the keyboard's reach")


class WithPad(Person):
    """Writes letter by letter."""

    def write(self, words: str) -> None:
        rows = self.tab.value(
            "[...document.querySelectorAll('[data-row]')].map((row) => row.textContent)"
        )
        for letter in words:
            row = next(place for place, letters in enumerate(rows, 1) if letter in letters)
            self.take(f".pad > :nth-child({row})")
            place = rows[row - 1].index(letter) + 1
            self.take(f".pad > :nth-child({row}) > :nth-child({place})")


class WithOneSwitch(WithPad):
    """Waits until the choice is lit, and presses."""

    one_switch = True

    def take(self, choice: str) -> None:
        # The light is held in the same breath, so that a slow machine presses at the right one.
        self.tab.wait_for(
            f"(() => {{if (!document.querySelector('.lit')?.matches({choice!r})) return false;"
            "window.participant.oneSwitch.next = Infinity; return true})()"
        )
        self.tab.wait_for("performance.now() - window.participant.oneSwitch.pressedAt > 400")
        press(self.tab, "x")


@dataclass
class Stick:
    """A stick that stays where it was put."""

    push: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def __call__(self) -> tuple[float, float, float]:
        return self.push


class WithStick(WithPad):
    """Pulls the stick back for the next choice and twists it to take one."""

    def __init__(self, tab: Tab, stick: Stick) -> None:
        super().__init__(tab)
        self.stick = stick

    def take(self, choice: str) -> None:
        for _ in range(MOST_KEYS):
            self.let_go()
            if self.tab.value(f"document.querySelector('.lit')?.matches({choice!r}) ?? false"):
                self.move((0.0, 0.0, 0.9))
                self.let_go()
                return
            self.move((-0.9, 0.1, 0.0))
        raise AssertionError(f"{choice} is out of the stick's reach")

    def let_go(self) -> None:
        self.stick.push = (0.02, -0.03, 0.0)
        self.tab.wait_for("window.participant.stick.ready || !window.participant.sheet", 20)

    def move(self, push: tuple[float, float, float]) -> None:
        self.stick.push = push
        self.tab.wait_for("!window.participant.stick.ready", 20)


def until(condition: Callable[[], bool], patience: float = 20.0) -> None:
    """Wait until a function gives truth."""
    end = time.monotonic() + patience
    while not condition():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.01)

"""Which keys are held at the participant's pages, for a device that is a keyboard."""

from __future__ import annotations

import time

from pydantic_core import to_json

HELD_S = 0.35
"""A page repeats every 0.1 s what is held; keys of one that fell silent count as let go."""
MOST = 16
"""Keys of one page, and letters of a key's code, that are listened to."""


class HeldKeys:
    """Adds up what several pages say."""

    def __init__(self) -> None:
        self._pages: dict[int, tuple[float, tuple[str, ...]]] = {}

    def hold(self, page: int, codes: tuple[str, ...]) -> bytes:
        """Take what one page says and give what is held on all, as JSON.

        codes : of the keyboard's places, such as ArrowUp or KeyW. `at` is on `time.monotonic`'s
        clock.
        """
        now = time.monotonic()
        self._pages[page] = (now, tuple(code[:MOST] for code in codes[:MOST]))
        self._pages = {
            one: (at, held) for one, (at, held) in self._pages.items() if now - at <= HELD_S
        }
        held = sorted({code for _, codes in self._pages.values() for code in codes})
        return to_json({"at": now, "held": held[:MOST]})

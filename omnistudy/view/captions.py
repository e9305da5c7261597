"""What a participant reads at an instant, from the events of a trial."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from omnistudy.channel import Event


class Caption(NamedTuple):
    """Sentences on the screen from `begin` to `end`, s since the trial opened."""

    begin: float
    end: float
    lines: tuple[str, ...]


class Captions:
    """Follows events; sentences that appear together leave together."""

    def __init__(self) -> None:
        self._open: list[tuple[float, list[str]]] = []
        self._closed: list[Caption] = []

    def take(self, event: Event) -> None:
        """Take the next event; those that show and close nothing are passed over."""
        if event.kind == "message":
            if not self._open or self._open[-1][0] != event.t:
                self._open.append((event.t, []))
            self._open[-1][1].append(event.detail)
        elif event.kind == "message_closed":
            for entry in self._open:
                begin, lines = entry
                if event.detail in lines:
                    self._open.remove(entry)
                    self._closed.append(Caption(begin, event.t, tuple(lines)))
                    break

    @property
    def now(self) -> tuple[str, ...]:
        """Sentences on the screen, the oldest first."""
        return tuple(line for _, lines in self._open for line in lines)

    def until(self, end: float) -> tuple[Caption, ...]:
        """Give everything that was shown; what is still open leaves at `end`."""
        rest = (Caption(begin, end, tuple(lines)) for begin, lines in self._open)
        return tuple(sorted((*self._closed, *rest)))


def captions(events: Iterable[Event], end: float) -> tuple[Caption, ...]:
    """Give all captions of a trial that lasted until `end` s."""
    following = Captions()
    for event in events:
        following.take(event)
    return following.until(end)

"""Somebody at the emulated stick who does what the checks before force say."""

from __future__ import annotations

from collections.abc import Callable

from omnistudy.devices.stick.checks import (
    HOLD_SWITCH,
    LEAVE_SWITCH,
    LET_GO,
    PRESS_STOP,
    RELEASE_STOP,
)
from omnistudy.devices.stick.emulator import EmulatedStick


class Attendant:
    """Does what is told, but for what is `refused`; remembers what was told."""

    def __init__(self, board: EmulatedStick, refused: str = "") -> None:
        self.board = board
        self.refused = refused
        self.told: list[str] = []

    def __call__(self, sentence: str) -> None:
        self.told.append(sentence)
        if sentence != self.refused:
            self._acts[sentence]()

    @property
    def _acts(self) -> dict[str, Callable[[], None]]:
        return {
            HOLD_SWITCH: self._make_ready,
            PRESS_STOP: lambda: self.board.press_estop(True),
            RELEASE_STOP: lambda: self.board.press_estop(False),
            LEAVE_SWITCH: lambda: self.board.hold_dead_man(False),
            LET_GO: self._let_go,
        }

    def _make_ready(self) -> None:
        self.board.press_estop(False)
        self.board.hold_dead_man(True)

    def _let_go(self) -> None:
        for axis in range(3):
            self.board.hold(axis, 0.0, 0.0, 0.0)

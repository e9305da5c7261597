"""Whoever is at the emulated stick and does what the checks before force say."""

from __future__ import annotations

from omnistudy.devices.stick.checks import (
    HOLD_SWITCH,
    LEAVE_SWITCH,
    LET_GO,
    PRESS_STOP,
    RELEASE_STOP,
)
from omnistudy.devices.stick.emulator import EmulatedStick


class Attendant:
    """Does at once what the checks ask for, but for the sentence `refused`."""

    def __init__(self, board: EmulatedStick, refused: str = "") -> None:
        self.board = board
        self._refused = refused
        self._acts = {
            HOLD_SWITCH: self.make_ready,
            PRESS_STOP: lambda: board.press_estop(True),
            RELEASE_STOP: lambda: board.press_estop(False),
            LEAVE_SWITCH: lambda: board.hold_dead_man(False),
            LET_GO: self.let_go,
        }

    def __call__(self, sentence: str) -> None:
        """Do what is told; what only informs needs no doing."""
        if sentence != self._refused and sentence in self._acts:
            self._acts[sentence]()

    def make_ready(self) -> None:
        """Release the emergency stop and hold the dead-man's switch."""
        self.board.press_estop(False)
        self.board.hold_dead_man(True)

    def let_go(self) -> None:
        """Take the hand off the handle."""
        for axis in range(3):
            self.board.hold(axis, 0.0, 0.0, 0.0)

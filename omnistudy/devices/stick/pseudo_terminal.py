"""The emulated stick behind a pseudo-terminal, where any program finds it as a serial port."""

from __future__ import annotations

import os
import select
import time
import tty
from collections.abc import Callable

from omnistudy.devices.stick.emulator import EmulatedStick

QUANTUM = 500e-6
"""s of emulated time between two looks at the terminal."""
LONGEST_LAG = 0.1
"""s behind wall time that are made good; what is more is left behind."""
CHUNK = 4096


class PseudoTerminal:
    """Carries bytes between the board and a terminal; emulated time passes in `carry` alone."""

    def __init__(self, board: EmulatedStick) -> None:
        self.board = board
        self._ours, theirs = os.openpty()
        tty.setraw(theirs)
        os.set_blocking(self._ours, False)
        # Kept open, so that the terminal outlives a program that closes it.
        self._theirs = theirs
        self.path = os.ttyname(theirs)

    def carry(self, seconds: float) -> None:
        """Let emulated time pass; raises ProcessorCrashed."""
        readable, _, _ = select.select((self._ours,), (), (), 0)
        if readable:
            self.board.write(os.read(self._ours, CHUNK))
        self.board.run(seconds)
        told = self.board.received()
        _, writable, _ = select.select((), (self._ours,), (), 0)
        # Nobody listens: what the terminal cannot hold is lost, as on a real line.
        if told and writable:
            os.write(self._ours, told)

    def keep_pace(self, until: Callable[[], bool]) -> None:
        """Carry bytes in step with wall time until `until` says so."""
        lead = self.board.now() - time.monotonic()
        while not until():
            behind = time.monotonic() + lead - self.board.now()
            if behind > LONGEST_LAG:
                lead -= behind
            elif behind < QUANTUM:
                select.select((self._ours,), (), (), QUANTUM)
            else:
                self.carry(QUANTUM)

    def close(self) -> None:
        """Take the terminal away."""
        os.close(self._theirs)
        os.close(self._ours)

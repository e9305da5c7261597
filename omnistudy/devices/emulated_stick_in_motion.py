"""The emulated stick during one trial: the board, its line, and the trial's hand on the handle."""

from __future__ import annotations

from functools import cached_property
from math import inf

from omnistudy.devices.device import NO_HAND, DeviceState, Hand
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.stick.conversion import configuration
from omnistudy.devices.stick.emulator import EmulatedStick, mechanisms
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Configuration
from omnistudy.devices.stick.transport import Transport
from omnistudy.devices.stick_on_line import StickOnLine
from omnistudy.errors.devices import CannotBePrescribed

SOFT_START = 10
"""ms; the trial begins when it is over."""
LET_GO = Hand((0.0,) * 3, (0.0,) * 3, (0.0,) * 3, (0.0,) * 3)


class EmulatedStickInMotion(StickOnLine):
    """A board of its own for each connection."""

    def __init__(self, device: EmulatedStickDevice, physics_hz: int) -> None:
        super().__init__(
            device.kind, device.stick, device.ceiling, device.added_damping, device.calibration
        )
        self._dt = 1.0 / physics_hz
        self._hand: Hand | None = None
        self._now: float | None = None

    @cached_property
    def board(self) -> EmulatedStick:
        """The board, powered up, its contacts closed."""
        board = EmulatedStick(mechanisms(self._stick))
        board.press_estop(False)
        board.hold_dead_man(True)
        return board

    def _open(self) -> Transport:
        return self.board

    def _settings(self, line: StickLine) -> Configuration:
        return configuration(self._stick)._replace(soft_start=SOFT_START)

    def advance(self, hand: Hand) -> DeviceState:
        """Let the board run for one step; give what its telemetry says at the end.

        Raises CannotBePrescribed.
        """
        if hand != self._hand:
            self._take(hand)
        line = self._reach()
        if line is None:
            return self._out_of_reach()
        if self._now is None:
            self.board.release()
            self._now = self.board.now()
        self._now += self._dt
        return self._hear(line, line.listen(self._now - self.board.now()))

    def _take(self, hand: Hand) -> None:
        grip = LET_GO if hand == NO_HAND else hand
        if grip.stiffness[0] == inf:
            raise CannotBePrescribed("emulated_stick")
        for axis in range(3):
            self.board.hold(
                axis, grip.stiffness[axis], grip.damping[axis], grip.mass[axis],
                grip.reference[axis],
            )  # fmt: skip
        self._hand = hand

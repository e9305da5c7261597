"""The emulated stick during one trial: the board, its line, and the trial's hand on the handle."""

from __future__ import annotations

from functools import cached_property
from math import inf

from omnistudy.channel import Channel
from omnistudy.devices.device import DeviceState, Hand, RunningDevice
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.stick.conversion import configuration, handle_scale
from omnistudy.devices.stick.emulator import EmulatedStick, mechanisms
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import Fault, State, Telemetry
from omnistudy.errors.devices import CannotBePrescribed, WentSoft
from omnistudy.geometry import ForceField

SOFT_START = 10
"""ms; the trial begins when it is over."""
SETTLING = 0.05
"""s from power-up or arming until the board is ready."""


class EmulatedStickInMotion(RunningDevice):
    """A board of its own for each trial."""

    forces = (True, True, True)
    channels = (
        Channel("motor_x", "N", "commanded motor force after clipping, with centring, nominal"),
        Channel("motor_y", "N", "commanded motor force after clipping, with centring, nominal"),
        Channel("motor_theta", "N·m", "commanded torque after clipping, with centring, nominal"),
        Channel("stick_worked", "1", "share of a tick until the motors were driven, greatest"),
        Channel("stick_missed", "1", "ticks that the firmware missed so far"),
    )

    def __init__(self, device: EmulatedStickDevice, physics_hz: int) -> None:
        self._stick = device.stick
        self._scale = handle_scale(device.stick)
        x, y, theta = self._scale.per_count
        self.axes = (
            Channel("stick_x", "m", "handle's travel, forward", x),
            Channel("stick_y", "m", "handle's travel, left", y),
            Channel("stick_theta", "rad", "handle's twist, counter-clockwise", theta),
        )
        self._dt = 1.0 / physics_hz
        self._hand: Hand | None = None
        self._worked = 0
        self._told: Telemetry | None = None

    @cached_property
    def _board(self) -> EmulatedStick:
        board = EmulatedStick(mechanisms(self._stick))
        board.press_estop(False)
        board.hold_dead_man(True)
        return board

    @cached_property
    def _line(self) -> StickLine:
        line = StickLine(self._board)
        line.listen(SETTLING)
        line.configure(configuration(self._stick)._replace(soft_start=SOFT_START))
        line.arm()
        line.listen(SETTLING)
        self._board.release()
        self._now = self._board.now()
        return line

    def values(self) -> tuple[float, ...]:
        """Give the motor forces of the last tick and how the firmware kept up."""
        if self._told is None:
            return (0.0,) * len(self.channels)
        return (*self._scale.force(self._told), self._worked / 16_000, float(self._told.missed))

    def render(self, field: ForceField) -> None:
        """Send a field over the emulated line."""
        self._line.send(self._scale.wire(field))

    def advance(self, hand: Hand) -> DeviceState:
        """Let the board run for one step; give what its telemetry says at the end.

        Raises CannotBePrescribed, WentSoft.
        """
        line = self._line
        if hand != self._hand:
            self._take(hand)
        self._now += self._dt
        heard = line.listen(self._now - self._board.now())
        if heard:
            self._told = heard[-1]
            self._worked = max(one.worked for one in heard)
            if self._told.state not in (State.RISING, State.FORCE, State.FADING):
                faults = Fault(self._told.faults).name or "no fault"
                raise WentSoft(State(self._told.state).name, faults)
        assert self._told is not None
        return self._scale.state(self._told)

    def _take(self, hand: Hand) -> None:
        if hand.stiffness[0] == inf:
            raise CannotBePrescribed("emulated_stick")
        for axis in range(3):
            self._board.hold(
                axis, hand.stiffness[axis], hand.damping[axis], hand.mass[axis],
                hand.reference[axis],
            )  # fmt: skip
        self._hand = hand

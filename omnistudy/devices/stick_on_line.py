"""A stick with our firmware during a trial, whatever carries its line."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from functools import cached_property

from omnistudy.channel import Channel
from omnistudy.devices.device import DeviceState, Health, Identity, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.ceiling import Ceiling
from omnistudy.devices.stick.conversion import handle_scale
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import (
    CYCLES_PER_TICK,
    Configuration,
    Disarm,
    Hello,
    Telemetry,
    Three,
)
from omnistudy.devices.stick.passivity import AddedDamping, PassivityObserver
from omnistudy.devices.stick.tally import Tally
from omnistudy.devices.stick.transport import Transport
from omnistudy.devices.stick.watch import Expected, Watch
from omnistudy.errors import OmnistudyError
from omnistudy.errors.devices import NoAnswer, PortLost, Refused
from omnistudy.errors.force_calibration import CalibrationOfAnother
from omnistudy.geometry import ForceField

SETTLING = 0.05
"""s from power-up or arming until the board is ready."""
FIELDS_AN_ASKING = 50
"""Fields between two askings who the stick is: a second (ours)."""
STILL = DeviceState((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
"""What drives nowhere: a stick in trouble says it."""


class StickOnLine(RunningDevice):
    """Sends fields, hears telemetry, watches over it; once in trouble it stays soft."""

    forces = (True, True, True)
    wrench = "clipped"
    channels = (
        Channel("motor_x", "N", "commanded motor force after clipping, with centring"),
        Channel("motor_y", "N", "commanded motor force after clipping, with centring"),
        Channel("motor_theta", "N·m", "commanded torque after clipping, with centring"),
        Channel("stick_worked", "1", "share of a tick until the motors were driven"),
        Channel("stick_missed", "1", "ticks that the firmware missed so far"),
        Channel("stick_tick", "ms", "the stick's own time"),
        Channel("stick_state", "1", "state of the firmware, docs/joystick-protocol.md"),
        Channel("stick_signs", "1", "saturation, enable line, switches, as bits"),
        Channel("stick_faults", "1", "faults of the firmware, as bits"),
        Channel("energy_x", "J", "taken from the hand in x; below zero: given to it"),
        Channel("energy_y", "J", "taken from the hand in y; below zero: given to it"),
        Channel("energy_theta", "J", "taken from the hand in theta; below zero: given to it"),
    )

    def __init__(
        self,
        model: str,
        stick: SimulatedStick,
        ceiling: Ceiling,
        added_damping: AddedDamping | None,
        calibration: ForceCalibration | None,
    ) -> None:
        self._model = model
        self._stick = stick
        self._scale = handle_scale(stick, calibration)
        self._calibration = calibration
        self._ceiling = ceiling
        self._added_damping = added_damping
        x, y, theta = self._scale.per_count
        self.axes = (
            Channel("stick_x", "m", "handle's travel, forward", x),
            Channel("stick_y", "m", "handle's travel, left", y),
            Channel("stick_theta", "rad", "handle's twist, counter-clockwise", theta),
        )
        self._energy = PassivityObserver()
        self._rows: list[tuple[float, ...]] = []
        self._values = (0.0,) * len(self.channels)
        self._state = STILL
        self._rendered: tuple[float, DeviceState] | None = None
        self._fields = 0
        self._tally = Tally()
        self._damaged = 0
        self._trouble = ""

    @abstractmethod
    def _open(self) -> Transport:
        """Reach the stick; raises what the transport raises."""

    @abstractmethod
    def _settings(self, line: StickLine) -> Configuration:
        """Give the settings to use, but for the force limits."""

    @property
    def force_limits(self) -> Three:
        """PWM steps that the firmware lets through at most: the ceiling's."""
        return self._ceiling.duties(self._scale.per_duty)

    @cached_property
    def _line(self) -> StickLine:
        """The line to a stick that is armed.

        Raises NoAnswer, WrongProtocol, Refused, CalibrationOfAnother.
        """
        line = StickLine(self._open())
        line.listen(SETTLING)
        settings = self._settings(line)
        limits = self.force_limits
        x, y, theta = (min(pair) for pair in zip(settings.force_limit, limits, strict=True))
        limits = (x, y, theta)
        line.disarm()
        line.configure(settings._replace(force_limit=limits))
        self._who = line.identify()
        if self._calibration:
            self._calibration.check_serial(str(self._who.serial))
        line.arm()
        line.listen(SETTLING)
        self._damaged = line.deframer.damaged
        expected = Expected(self._who, self._stick.stops, limits)
        self._watch = Watch(expected, line.transport.now())
        return line

    def _reach(self) -> StickLine | None:
        """Give the line, or None with the trouble told when the stick cannot be armed."""
        if self._trouble and "_line" not in self.__dict__:
            return None
        try:
            return self._line
        except (Refused, NoAnswer, CalibrationOfAnother) as cause:
            self._trouble = str(cause)
            return None

    def values(self) -> tuple[float, ...]:
        """Give the last tick's values; `stick_worked` is the greatest of the last step."""
        return self._values

    def rows(self) -> Sequence[tuple[float, ...]]:
        """Give every tick that was heard during the last `advance`."""
        return self._rows

    def trouble(self) -> str:
        """Tell what was found first, for good; a new connection begins anew."""
        return self._trouble

    def health(self) -> Health:
        """Tell how well the line was heard since the stick was armed."""
        if "_line" not in self.__dict__:
            return self._tally.health(0)
        return self._tally.health(self._line.deframer.damaged - self._damaged)

    def identity(self) -> Identity:
        """Tell serial number and firmware; raises what opening the line raises."""
        self._reach()
        if "_line" not in self.__dict__:
            return Identity(self._model)
        calibration = self._calibration.name if self._calibration else ""
        serial, firmware = str(self._who.serial), f"{self._who.firmware:08x}"
        return Identity(self._model, serial, firmware, calibration)

    def render(self, field: ForceField) -> None:
        """Send a field, under the ceiling and with added damping; nothing goes out in trouble."""
        line = self._reach()
        if line is None or self._trouble:
            return
        if self._added_damping:
            field = self._damped(field, self._added_damping, line.transport.now())
        try:
            line.send(self._scale.wire(self._ceiling.bound(field, self._state)))
            self._fields += 1
            if self._fields % FIELDS_AN_ASKING == 0:
                line.send(Hello())
        except PortLost as cause:
            self._ail(cause)

    def close(self) -> None:
        """Disarm and end the line; a stick that is out of reach goes soft by its own silence."""
        if "_line" not in self.__dict__:
            return
        line = self._line
        self._disarm(line)
        line.transport.close()

    def _disarm(self, line: StickLine) -> None:
        try:
            line.send(Disarm())
        except PortLost as cause:
            self._ail(cause)

    def _ail(self, cause: OmnistudyError) -> None:
        """Tell what happened, unless there was trouble before."""
        self._trouble = self._trouble or str(cause)

    def _hear(self, line: StickLine, heard: list[Telemetry]) -> DeviceState:
        """Take what came within this step; give where the stick is now."""
        self._rows = rows = []
        worked = 0.0
        self._tally.take(heard)
        for told in heard:
            state, values = self._tell(told)
            worked = max(worked, values[3])
            rows.append((*state.position, *state.rate, *values))
            self._state, self._values = state, values
        if rows:
            self._values = (*self._values[:3], worked, *self._values[4:])
        self._judge(line, heard)
        return STILL if self._trouble else self._state

    def _out_of_reach(self) -> DeviceState:
        self._rows = []
        return STILL

    def _tell(self, told: Telemetry) -> tuple[DeviceState, tuple[float, ...]]:
        state, force = self._scale.state(told), self._scale.force(told)
        self._energy.see(state.position, force)
        return state, (
            *force,
            told.worked / CYCLES_PER_TICK,
            float(told.missed),
            float(told.tick),
            float(told.state),
            float(told.signs),
            float(told.faults),
            *self._energy.energy,
        )

    def _judge(self, line: StickLine, heard: list[Telemetry]) -> None:
        if self._trouble:
            return
        asked = self._watch.asks
        trouble = self._watch.look(heard, line.transport.now())
        for identity in line.met():
            trouble = trouble or self._watch.meet(identity)
        if trouble:
            self._trouble = trouble
            self._disarm(line)
        elif self._watch.asks and not asked:
            line.send(Hello())

    def _damped(self, field: ForceField, added: AddedDamping, now: float) -> ForceField:
        """Add the damping that makes good what the stick gave out since the last field."""
        before, self._rendered = self._rendered, (now, self._state)
        if before is None:
            return field
        then, was = before
        moved = [q - old for q, old in zip(self._state.position, was.position, strict=True)]
        x, y, theta = added.against(self._energy.energy, moved, now - then)
        (a, b, c), (d, e, f), (g, h, i) = field.damping
        return field._replace(damping=((a + x, b, c), (d, e + y, f), (g, h, i + theta)))

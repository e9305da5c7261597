"""A stick with our firmware during a trial, whatever carries its line."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from functools import cached_property

from omnistudy.devices.device import DeviceState, Health, Identity, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.devices.stick.ceiling import Ceiling
from omnistudy.devices.stick.conversion import handle_scale
from omnistudy.devices.stick.force_calibration import ForceCalibration
from omnistudy.devices.stick.layouts import Message
from omnistudy.devices.stick.line import StickLine
from omnistudy.devices.stick.messages import (
    ARM_KEY,
    Arm,
    Configuration,
    Disarm,
    Hello,
    Telemetry,
    Three,
)
from omnistudy.devices.stick.passivity import AddedDamping, PassivityObserver
from omnistudy.devices.stick.tally import Tally
from omnistudy.devices.stick.transport import Transport
from omnistudy.devices.stick.watch import SOFT, Expected, Watch
from omnistudy.devices.stick_channels import CHANNELS, WORKED, axes, values
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
    channels = CHANNELS

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
        self.axes = axes(self._scale.per_count)
        self._energy = PassivityObserver()
        self._rows: list[tuple[float, ...]] = []
        self._values = (0.0,) * len(self.channels)
        self._state = STILL
        self._rendered: tuple[float, DeviceState] | None = None
        self._fields = 0
        self._tally = Tally(self.force_limits)
        self._damaged = 0
        self._trouble = ""
        self._resting = False
        self._soft = True

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
        """The line to a stick that is not armed yet.

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
        self._tally = Tally(limits)
        expected = Expected(self._who, self._stick.stops, limits)
        self._watch = Watch(expected, line.transport.now())
        self._watch.resting = self._resting
        return line

    def _reach(self) -> StickLine | None:
        """Give the line to the stick that was armed, or None with the trouble told."""
        if "_line" in self.__dict__:
            return self._line
        if self._trouble:
            return None
        try:
            line = self._line
            self._arm_first(line)
        except (Refused, NoAnswer, CalibrationOfAnother) as cause:
            self._trouble = str(cause)
            return None
        return line

    def _arm_first(self, line: StickLine) -> None:
        """Arm and wait until the stick is ready; at rest it may as well be armed later."""
        try:
            line.arm()
        except Refused:
            if not self._resting:
                raise
        else:
            self._soft = False
        line.listen(SETTLING)
        self._damaged = line.deframer.damaged
        self._watch.begin(line.transport.now())

    def rest(self) -> None:
        """Let the hand go its way between trials: a switch that is let go is no trouble then."""
        self._resting = True
        if "_line" in self.__dict__:
            self._watch.resting = True

    def wake(self) -> None:
        """Begin a trial: have force again if it was let go meanwhile, and count energy anew."""
        self._resting = False
        self._energy = PassivityObserver()
        line = self._reach()
        if line is None or self._trouble:
            return
        self._watch.wake(line.transport.now())
        if self._soft:
            self._send(line, Arm(ARM_KEY))

    def _send(self, line: StickLine, message: Message) -> None:
        try:
            line.send(message)
        except PortLost as cause:
            self._ail(cause)

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
        self._send(line, self._scale.wire(self._ceiling.bound(field, self._state)))
        self._fields += 1
        if self._fields % FIELDS_AN_ASKING == 0:
            self._send(line, Hello())

    def close(self) -> None:
        """Disarm and end the line; a stick that is out of reach goes soft by its own silence."""
        if "_line" not in self.__dict__:
            return
        line = self._line
        self._send(line, Disarm())
        line.transport.close()

    def _ail(self, cause: OmnistudyError) -> None:
        """Tell what happened, unless there was trouble before."""
        self._trouble = self._trouble or str(cause)

    def _hear(self, line: StickLine, heard: list[Telemetry]) -> DeviceState:
        """Take what came within this step; give where the stick is now."""
        self._rows = rows = []
        worked = 0.0
        self._tally.take(heard)
        for told in heard:
            self._state, self._values = self._tell(told)
            worked = max(worked, self._values[WORKED])
            rows.append((*self._state.position, *self._state.rate, *self._values))
        if heard:
            self._soft = heard[-1].state in SOFT
            self._values = (*self._values[:WORKED], worked, *self._values[WORKED + 1 :])
        self._judge(line, heard)
        return STILL if self._trouble else self._state

    def _out_of_reach(self) -> DeviceState:
        self._rows = []
        return STILL

    def _tell(self, told: Telemetry) -> tuple[DeviceState, tuple[float, ...]]:
        state, force = self._scale.state(told), self._scale.force(told)
        self._energy.see(state.position, force)
        return state, values(told, force, self._energy.energy)

    def _judge(self, line: StickLine, heard: list[Telemetry]) -> None:
        if not self._trouble:
            self._watch_over(line, heard)
        if self._trouble and not self._soft:
            # Again with every look until it is soft: a frame may have been lost.
            self._send(line, Disarm())

    def _watch_over(self, line: StickLine, heard: list[Telemetry]) -> None:
        asked = self._watch.asks
        trouble = self._watch.look(heard, line.transport.now())
        for identity in line.met():
            trouble = trouble or self._watch.meet(identity)
        self._trouble = trouble
        if self._watch.asks and not asked:
            self._send(line, Hello())

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

"""What all bought devices share: three mapped axes, a travel, a rate, force where there is some."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from math import exp
from typing import Annotated, ClassVar

from pydantic import Field

from omnistudy.channel import Channel, Measure
from omnistudy.devices.device import (
    Device,
    DeviceState,
    Hand,
    Health,
    Identity,
    RunningDevice,
)
from omnistudy.devices.handheld.axes import AxisMap, MappedAxis, Travel
from omnistudy.devices.handheld.force_effects import (
    NO_EFFECTS,
    Lever,
    Strength,
    effects_of,
    force_of,
)
from omnistudy.devices.handheld.hardware import Hardware
from omnistudy.errors import OmnistudyError
from omnistudy.geometry import ForceField
from omnistudy.units import Seconds

STICK_AXES = (
    Channel("stick_x", "m", "deflection forward, on the travel of the thesis's stick"),
    Channel("stick_y", "m", "deflection left, on the travel of the thesis's stick"),
    Channel("stick_theta", "rad", "twist counter-clockwise, on the travel of the thesis's stick"),
)
FORCE_CHANNELS = (
    Channel("commanded_x", "N", "force that the device was told to make, clipped; not measured"),
    Channel("commanded_y", "N", "force that the device was told to make, clipped; not measured"),
)


class Handheld(Device, ABC):
    """Parameters of a bought device; a kind says how it is reached and which axes it has."""

    in_lockstep: ClassVar[bool] = False
    apart: ClassVar[bool] = True
    tick_hz: ClassVar[int] = 250

    name: str = ""
    """Part of the name it tells, where several are plugged in; empty: any."""
    serial: str = ""
    """Serial number that it tells, where several are plugged in; empty: any."""
    x: AxisMap
    """Forward."""
    y: AxisMap
    """Left."""
    theta: AxisMap
    """Counter-clockwise."""
    travel: Travel = Travel()
    rate_smoothing: Annotated[Seconds, Field(ge=0)] = 0.02
    """Time constant of the rate, which is the smoothed difference of positions (ours)."""
    calibrated: str = ""
    """When and on which device the ranges were found; `omnistudy device calibrate` writes it."""

    @property
    def maps(self) -> tuple[AxisMap, AxisMap, AxisMap]:
        """The three axes of the stick."""
        return self.x, self.y, self.theta

    @property
    def rendered(self) -> Strength | None:
        """How strong its motors are; None for a device that is to push nothing."""
        return None

    @abstractmethod
    def reach(self) -> Hardware:
        """Open the device; raises what its driver meets (errors/handheld.py)."""

    def before_force(
        self, tell: Callable[[str], None], expected: Identity | None = None
    ) -> tuple[Measure, ...]:
        """Make sure that it is the same device and rests; raises AnotherDevice or NotAtRest."""
        from omnistudy.devices.handheld.before_driving import checked

        return checked(self, tell, expected)

    def connect(self, physics_hz: int) -> RunningHandheld:
        """Give the device, to be asked `physics_hz` times a second; first use opens it."""
        return RunningHandheld(self, physics_hz)


class RunningHandheld(RunningDevice):
    """A bought device in use, opened at first use, which raises what `Handheld.reach` raises.

    When it is unplugged it tells rest and stays in trouble.
    """

    axes = STICK_AXES
    forces = (False, False, False)

    def __init__(self, handheld: Handheld, tick_hz: int) -> None:
        self._handheld = handheld
        travel, smoothing = handheld.travel, handheld.rate_smoothing
        self._travel = (travel.x, travel.y, travel.theta)
        self._tick = 1.0 / tick_hz
        self._renewed = 1.0 - exp(-self._tick / smoothing) if smoothing else 1.0
        self._strength = handheld.rendered
        self.channels = FORCE_CHANNELS if self._strength else ()
        self._hardware: Hardware | None = None
        self._maps: tuple[MappedAxis, ...] = ()
        self._levers: tuple[Lever | None, Lever | None] = (None, None)
        self.raw: tuple[float, ...] = ()
        self._position = self._rate = (0.0, 0.0, 0.0)
        self._effects = NO_EFFECTS
        self._age = 0.0
        self._ticks = 0
        self._saturated = [0, 0, 0]

    @property
    def hardware(self) -> Hardware:
        """The opened device; raises what `Handheld.reach` raises."""
        if self._hardware is None:
            hardware = self._handheld.reach()
            try:
                self._maps = tuple(one.on(hardware.axes) for one in self._handheld.maps)
            except OmnistudyError:
                hardware.close()
                raise
            self._hardware = hardware
            self.raw = hardware.read()
            self._position = self._where()
            self._find_levers(hardware)
        return self._hardware

    def render(self, field: ForceField) -> None:
        """Tell the motors, where there are any, what to render."""
        motors, strength = self.hardware.motors, self._strength
        if motors is None or strength is None:
            return
        self._effects = effects_of(
            field, self._position, self._levers, strength, motors.springs, motors.dampers
        )
        self._age = 0.0
        motors.apply(self._effects)

    def advance(self, hand: Hand) -> DeviceState:
        """Give the newest that came; `hand` is a real one. Unplugged, it rests in its centre."""
        hardware = self.hardware
        self.raw = hardware.read()
        self._ticks += 1
        self._age += self._tick
        if hardware.trouble():
            self._position = self._rate = (0.0, 0.0, 0.0)
            return DeviceState(self._position, self._rate)
        before, self._position = self._position, self._where()
        x, y, theta = (
            rate + self._renewed * ((now - then) / self._tick - rate)
            for rate, now, then in zip(self._rate, self._position, before, strict=True)
        )
        self._rate = (x, y, theta)
        self._count_saturated()
        return DeviceState(self._position, self._rate)

    def values(self) -> tuple[float, ...]:
        """Give the commanded force, where there is one."""
        if self._strength is None:
            return ()
        return force_of(
            self._effects, self._position, self._rate, self._age, self._levers, self._strength
        )

    def rows(self) -> Sequence[tuple[float, ...]]:
        """Give one row: what `advance` found."""
        return ((*self._position, *self._rate, *self.values()),)

    def health(self) -> Health:
        """Tell how often it was asked, and when its motors were told to give all they have."""
        return Health(ticks=self._ticks, saturated=tuple(self._saturated))

    def identity(self) -> Identity:
        """Tell model and serial number, and when its force was measured."""
        measured = self._strength.measured if self._strength else ""
        return self.hardware.identity()._replace(calibration=measured)

    def trouble(self) -> str:
        """Tell whether it was unplugged."""
        return self._hardware.trouble() if self._hardware else ""

    def close(self) -> None:
        """Take the force away and let go."""
        if self._hardware is not None:
            self._hardware.close()
            self._hardware = None

    def _where(self) -> tuple[float, float, float]:
        x, y, theta = (
            one.deflection(self.raw) * travel
            for one, travel in zip(self._maps, self._travel, strict=True)
        )
        return (x, y, theta)

    def _count_saturated(self) -> None:
        if self._strength is None:
            return
        for axis, force in enumerate(self.values()):
            self._saturated[axis] += abs(force) >= self._strength.force

    def _find_levers(self, hardware: Hardware) -> None:
        """Find which axis of the stick each of the device's two motors pushes along."""
        if hardware.motors is None or self._strength is None:
            return
        x, y = (self._lever(name) for name in hardware.pushed)
        self._levers = (x, y)
        pushed = [lever.axis for lever in self._levers if lever]
        self.forces = (0 in pushed, 1 in pushed, False)
        self.wrench = "clipped"

    def _lever(self, name: str) -> Lever | None:
        for axis in (0, 1):
            mapped = self._handheld.maps[axis]
            if mapped.axis == name and not mapped.opposite:
                return Lever(axis, mapped.sign, self._travel[axis])
        return None

"""What every device can do: be held by a hand, render a force field, tell where it is."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import ClassVar, Literal, NamedTuple, Self

import numpy as np
from numpy.typing import NDArray

from omnistudy.channel import Channel, Measure
from omnistudy.geometry import ForceField
from omnistudy.registry import KindModel


class DeviceState(NamedTuple):
    """Where the device is, as its own sensors tell it.

    position : one number an axis, SI (the 3-DOF stick: m, m, rad).
    rate : the same per second.
    """

    position: tuple[float, ...]
    rate: tuple[float, ...]


class Hand(NamedTuple):
    """A hand on the device: one spring, damper and mass an axis, pulled to `reference`.

    reference : where the hand wants the device, in the device's own coordinates.
    stiffness, damping, mass : per axis, SI. A hand with infinite stiffness prescribes the position.
    """

    reference: tuple[float, ...]
    stiffness: tuple[float, ...]
    damping: tuple[float, ...]
    mass: tuple[float, ...]


NO_HAND = Hand((), (), (), ())
"""Nobody whom we could move: a real hand holds the device, or none. It fits every device."""


class Identity(NamedTuple):
    """Which piece of hardware it is, as far as it tells; "" where it does not.

    calibration : date and digest of what counts and PWM steps were found to be; "" is nominal.
    """

    model: str
    serial: str = ""
    firmware: str = ""
    calibration: str = ""


class Health(NamedTuple):
    """How well a device was heard since it was connected; counts, none of which ever falls.

    ticks : of the device that were heard. missed : known to be lost on the way.
    damaged : frames that could not be read.
    saturated : ticks at which an axis pushed with all it has, one number an axis.
    """

    ticks: int = 0
    missed: int = 0
    damaged: int = 0
    saturated: tuple[int, ...] = ()

    def since(self, before: Health) -> Health:
        """Give what was counted since an earlier moment."""
        earlier = before.saturated or (0,) * len(self.saturated)
        return Health(
            self.ticks - before.ticks,
            self.missed - before.missed,
            self.damaged - before.damaged,
            tuple(now - then for now, then in zip(self.saturated, earlier, strict=True)),
        )


Wrench = Literal["none", "commanded", "clipped", "measured"]
"""What a device's recorded force is: none, what was asked of its motors, that after all limits, or
what a sensor felt."""


class Device(KindModel, ABC):
    """Parameters of a device; `connect` makes the running one."""

    in_lockstep: ClassVar[bool] = True
    """False: real hardware, whose time nobody can stop; it serves live trials only."""
    apart: ClassVar[bool] = False
    """In a live trial it runs in a process of its own, `tick_hz` turns a second."""
    tick_hz: ClassVar[int] = 1000

    def at(self, study: Path) -> Self:
        """Give the device as it is reached while a study runs; most are reached everywhere."""
        return self

    def before_force(
        self, tell: Callable[[str], None], expected: Identity | None = None
    ) -> tuple[Measure, ...]:
        """Have somebody at the device check what must be sound before it pushes; give the findings.

        Done before a session and after each trouble, while the device is not connected. A device
        that needs no such checks finds nothing.
        tell : shows a sentence to whoever is there. expected : which device it was before.
        Raises what forbids force.
        """
        return ()

    @abstractmethod
    def connect(self, physics_hz: int) -> RunningDevice:
        """Give the device at rest in its centre; it is advanced `physics_hz` times a second.

        No hardware is touched before it is first advanced, so that anything can be described.
        """

    def own_force(
        self, position: NDArray[np.float64], rate: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Give what its motors push without any field, such as centring; none unless overridden.

        position, rate and result : (n, axes), SI.
        """
        return np.zeros_like(position)


class RunningDevice(ABC):
    """A device during one trial."""

    axes: tuple[Channel, ...]
    """Name, unit, meaning and resolution of each position axis; a rate has the same resolution."""

    channels: tuple[Channel, ...] = ()
    """What else is worth recording, besides the axes; see `values`."""

    def values(self) -> tuple[float, ...]:
        """Give the present value of each channel."""
        return ()

    forces: tuple[bool, ...] = ()
    """Whether it can push along each axis; data of an axis that cannot say so."""

    wrench: Wrench = "none"
    """What the force among its `channels` is."""

    @abstractmethod
    def render(self, field: ForceField) -> None:
        """Take a new force field; it holds until the next or until it is stale."""

    @abstractmethod
    def advance(self, hand: Hand) -> DeviceState:
        """Let one step pass with a hand on the device; give what the sensors then say.

        Real hardware takes no notice of `hand` and never waits: it gives the newest that came.
        """

    def rest(self) -> None:
        """Let the hand go its way until `wake`: no trial goes on, and letting go is no trouble."""
        return

    def wake(self) -> None:
        """Begin a trial after a rest."""
        return

    def rows(self) -> Sequence[tuple[float, ...]]:
        """Give what it told during the last `advance`, oldest first: position, rate, values."""
        return ()

    def health(self) -> Health:
        """Tell how well it was heard so far."""
        return Health()

    def identity(self) -> Identity:
        """Tell which piece of hardware this is."""
        return Identity(type(self).__name__)

    def trouble(self) -> str:
        """Tell in one clause why it cannot be driven with now; "" while all is well."""
        return ""

    def close(self) -> None:
        """Let the hardware go; whatever pushes must then be soft."""
        return

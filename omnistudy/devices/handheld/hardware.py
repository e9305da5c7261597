"""What every driver of a bought device can do: tell its axes, and push where it has motors."""

from __future__ import annotations

from abc import ABC, abstractmethod

from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.axes import HardwareAxis
from omnistudy.devices.handheld.force_effects import ForceEffects


class Motors(ABC):
    """The motors of a device, along its first two axes; they fade by themselves when left alone."""

    springs: bool
    """Whether the device renders a spring itself."""
    dampers: bool
    """Whether the device renders a damper itself."""

    @abstractmethod
    def apply(self, effects: ForceEffects) -> None:
        """Push in this way from now on, for as long as the effects are valid; never waits."""

    @abstractmethod
    def stop(self) -> None:
        """Leave the device without force."""

    @abstractmethod
    def close(self) -> None:
        """Let go of the motors, without force."""


class Hardware(ABC):
    """A device that is plugged in. Nothing here waits or raises after it was opened."""

    axes: tuple[HardwareAxis, ...]
    """What it can tell; `read` gives numbers in this order."""
    motors: Motors | None = None
    """Along axes X and Y of the device, which are `pushed`."""
    pushed: tuple[str, str] = ("", "")
    """Names of the axes along which the motors push."""

    @abstractmethod
    def read(self) -> tuple[float, ...]:
        """Take in everything that came and give the newest number of each axis."""

    @abstractmethod
    def trouble(self) -> str:
        """Tell in one clause why it cannot be read now; "" while all is well."""

    @abstractmethod
    def identity(self) -> Identity:
        """Tell which piece of hardware this is."""

    @abstractmethod
    def close(self) -> None:
        """Let go of it; whatever pushes is then soft."""

"""Which device an attempt was driven with, and what its recorded force is worth."""

from __future__ import annotations

from typing import Literal, NamedTuple

from omnistudy.devices.device import Identity, RunningDevice, Wrench

Scale = Literal["nominal", "calibrated"]
"""Whether newtons come from data sheets, or from a calibration of this very device."""


class DeviceRecord(NamedTuple):
    """What is stored about the device of an attempt.

    pushes : axes along which it can push.
    wrench : what its recorded force is.
    """

    kind: str
    identity: Identity
    pushes: tuple[str, ...]
    wrench: Wrench

    @property
    def scale(self) -> Scale:
        """What its newtons are worth."""
        return "calibrated" if self.identity.calibration else "nominal"


def record_of(kind: str, device: RunningDevice) -> DeviceRecord:
    """Describe a device that is connected and awake."""
    pushes = tuple(
        axis.name for axis, pushed in zip(device.axes, device.forces, strict=False) if pushed
    )
    return DeviceRecord(kind, device.identity(), pushes, device.wrench)

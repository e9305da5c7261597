"""Joysticks and what they render."""

from omnistudy.devices.device import (
    NO_HAND,
    Device,
    DeviceState,
    Hand,
    Health,
    Identity,
    RunningDevice,
    Wrench,
)

__all__ = [
    "NO_HAND",
    "Device",
    "DeviceState",
    "Hand",
    "Health",
    "Identity",
    "RunningDevice",
    "Wrench",
]

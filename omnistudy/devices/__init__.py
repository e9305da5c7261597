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
from omnistudy.devices.record import DeviceRecord, Scale, record_of

__all__ = [
    "NO_HAND",
    "Device",
    "DeviceRecord",
    "DeviceState",
    "Hand",
    "Health",
    "Identity",
    "RunningDevice",
    "Scale",
    "Wrench",
    "record_of",
]

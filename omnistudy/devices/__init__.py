"""Joysticks and what they render."""

from omnistudy.devices.device import Device, DeviceState, Hand, Identity, RunningDevice

__all__ = ["Device", "DeviceState", "Hand", "Identity", "RunningDevice"]

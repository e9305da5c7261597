"""Joysticks and what they render."""

from omnistudy.devices.device import Device, DeviceState, Hand, RunningDevice

__all__ = ["Device", "DeviceState", "Hand", "RunningDevice"]

"""Devices that labs own: gamepads, twist sticks, force sticks, space mice, keyboards."""

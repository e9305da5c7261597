"""Looks a bought device over before it is used."""

from __future__ import annotations

import time

from omnistudy.devices.device import NO_HAND
from omnistudy.devices.handheld.axes import AxisMap
from omnistudy.devices.handheld.calibration import AXES
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.stick.check import Finding


def check_handheld(device: Handheld, seconds: float = 1.0) -> tuple[Finding, ...]:
    """Give what is found while nobody touches it; no force. Raises what opening it raises."""
    running = device.connect(device.tick_hz)
    try:
        seen = []
        for _ in range(max(2, round(seconds * device.tick_hz))):
            seen.append(running.advance(NO_HAND).position)
            time.sleep(1.0 / device.tick_hz)
        identity = running.identity()
        told = [one.name for one in running.hardware.axes]
        trouble = running.trouble()
        pushes = [axis for axis, can in zip(AXES, running.forces, strict=True) if can]
    finally:
        running.close()
    moved = [
        axis for axis, values in zip(AXES, zip(*seen, strict=True), strict=True) if any(values)
    ]
    maps = [f"{axis} by {_moved_by(one)}" for axis, one in zip(AXES, device.maps, strict=True)]
    return (
        Finding("model", identity.model, True),
        Finding("serial number", identity.serial or "it tells none", True),
        Finding("axes and buttons", ", ".join(told), True),
        Finding("moves the stick", ", ".join(maps), True),
        Finding("calibrated", device.calibrated or "not: `omnistudy device calibrate`", True),
        Finding("at rest", f"{', '.join(moved)} moved" if moved else "all axes", not moved),
        Finding("force", f"along {' and '.join(pushes)}" if pushes else "on no axis", True),
        Finding("plugged in", trouble or "all the time", not trouble),
    )


def _moved_by(one: AxisMap) -> str:
    return f"{one.axis} and {one.opposite}" if one.opposite else one.axis

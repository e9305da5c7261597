"""Leads a person through the calibration of a bought device, and writes the page."""

from __future__ import annotations

import time
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
import yaml

from omnistudy.devices.device import Identity
from omnistudy.devices.handheld.calibration import (
    HELD_S,
    AxisFound,
    Recorded,
    Step,
    calibrated,
    found_in,
    steps_of,
)
from omnistudy.devices.handheld.handheld import Handheld, RunningHandheld
from omnistudy.errors.handheld import NothingToCalibrate, Unplugged
from omnistudy.geometry import NO_FORCE

Lead = Callable[[Step], None]
"""Shows a step, and returns when the person does it."""


class Calibration(NamedTuple):
    """A device as it was found."""

    device: Handheld
    identity: Identity
    found: tuple[AxisFound, ...]


def calibrate(device: Handheld, lead: Lead) -> Calibration:
    """Lead through every step; the device gives no force meanwhile.

    Raises NothingToCalibrate, Unplugged, DidNotMove, Unsteady, and what opening it raises.
    """
    steps = steps_of(device)
    if not steps:
        raise NothingToCalibrate(device.kind)
    running = device.connect(device.tick_hz)
    try:
        hardware = running.hardware
        running.render(NO_FORCE)  # also switches the device's own centring off
        recorded = tuple(_record(running, step, lead, device.tick_hz) for step in steps)
        identity = running.identity()
        found = found_in(device, hardware.axes, recorded)
    finally:
        running.close()
    serial = f", serial number {identity.serial}" if identity.serial else ""
    made = f"{date.today().isoformat()}, {identity.model}{serial}"
    return Calibration(calibrated(device, found, made), identity, found)


def page_of(calibration: Calibration, page: str) -> str:
    """Give the YAML page of a calibrated device; `page` names the one it started from."""
    return page_text(calibration.device, f"{page}, calibrated {calibration.device.calibrated}")


def page_text(device: Handheld, summary: str) -> str:
    """Give a device as a YAML page that says what was given or found, and a summary."""
    tree: dict[str, Any] = device.model_dump(mode="json", exclude_unset=True)
    tree.pop("kind", None)
    body = yaml.safe_dump(tree, sort_keys=False, allow_unicode=True)
    return f"kind: {device.kind}  # {summary}\n{body}"


def write_page(file: Path, text: str) -> None:
    """Write a page of the lab's, its folder made when missing; what was there is replaced."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(text, encoding="utf-8")


def _record(running: RunningHandheld, step: Step, lead: Lead, tick_hz: int) -> Recorded:
    lead(step)
    samples = []
    for _ in range(max(2, round(HELD_S * tick_hz))):
        samples.append(running.hardware.read())
        time.sleep(1.0 / tick_hz)
    if running.trouble():
        raise Unplugged(running.trouble())
    return Recorded(step, np.array(samples))

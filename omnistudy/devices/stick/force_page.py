"""Readings from a file, and the page of a stick whose forces were found."""

from __future__ import annotations

import csv
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import yaml

from omnistudy.devices.device import Device
from omnistudy.devices.stick.force_calibration import AxisForce, ForceCalibration
from omnistudy.devices.stick.force_fit import Reading, fit
from omnistudy.devices.stick.force_steps import AXES
from omnistudy.errors.force_calibration import BrokenReadings

COLUMNS = ("axis", "duty", "force")
DIGITS = 5
"""Significant ones of what a page says; a calibration knows two or three."""


def read_readings(file: Path) -> list[Reading]:
    """Read a CSV file with the columns axis, duty and force; raises BrokenReadings."""
    try:
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as cause:
        raise BrokenReadings(str(file), "cannot be read as text") from cause
    rows = csv.DictReader(text.splitlines())
    if tuple(rows.fieldnames or ()) != COLUMNS:
        given = ", ".join(rows.fieldnames or ()) or "nothing"
        raise BrokenReadings(f"{file}, line 1", f"its columns are {given}")
    return [_reading(row, f"{file}, line {rows.line_num}") for row in rows]


def _reading(row: dict[str, str], where: str) -> Reading:
    try:
        return Reading(AXES.index(row["axis"]), int(row["duty"]), float(row["force"]))
    except (ValueError, TypeError) as cause:
        given = ", ".join(f"{name} '{value}'" for name, value in row.items())
        raise BrokenReadings(where, f"{given} is no reading") from cause


def write_readings(file: Path, readings: Sequence[Reading]) -> None:
    """Write readings as `read_readings` takes them."""
    with file.open("w", encoding="utf-8", newline="") as out:
        table = csv.writer(out)
        table.writerow(COLUMNS)
        table.writerows((AXES[one.axis], one.duty, one.force) for one in readings)


def fitted(readings: Sequence[Reading]) -> tuple[AxisForce, AxisForce, AxisForce]:
    """Fit each axis by itself; raises TooFewReadings, NoForceRead."""
    x, y, theta = (
        _rounded(fit(name, [one for one in readings if one.axis == axis]))
        for axis, name in enumerate(AXES)
    )
    return (x, y, theta)


def _rounded(axis: AxisForce) -> AxisForce:
    told = {
        name: float(f"{value:.{DIGITS}g}") if isinstance(value, float) else value
        for name, value in axis.model_dump().items()
    }
    return AxisForce(**told)


def page_of(device: Device, calibration: ForceCalibration, page: str) -> str:
    """Give the YAML page of a device with its calibration; `page` is where it started from."""
    tree: dict[str, Any] = device.model_dump(mode="json", exclude_unset=True)
    tree.pop("kind", None)
    tree["calibration"] = calibration.model_dump(mode="json")
    summary = f"{page}, its force calibrated {calibration.name}"
    body = yaml.safe_dump(tree, sort_keys=False, allow_unicode=True)
    return f"kind: {device.kind}  # {summary}\n{body}"

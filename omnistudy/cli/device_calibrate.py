"""`omnistudy device calibrate`: leads through the steps, asks before it replaces a page."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import typer

from omnistudy.cli.device_chosen import hardware_of
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.devices.handheld.calibrating import Calibration, Lead
    from omnistudy.devices.handheld.calibration import Step


def find_ranges(given: str, page: str, replace: bool, dry_run: bool, json: bool) -> None:
    """Calibrate the axes of a bought device and write its page; see the verb."""
    from omnistudy.devices.handheld.calibrating import calibrate, page_of, write_page
    from omnistudy.devices.handheld.calibration import steps_of
    from omnistudy.lab import default_folder

    device = hardware_of(given, "calibrate")
    file = default_folder() / "device" / f"{page}.yaml"
    if file.exists() and not (replace or dry_run):
        typer.confirm(f"{file} is there: replace it?", abort=True, err=True)
    found = calibrate(device, _leader(len(steps_of(device))))
    text = page_of(found, given)
    if not dry_run:
        write_page(file, text)
    if json:
        print_json(
            {
                "written": not dry_run,
                "file": file,
                "model": found.identity.model,
                "serial": found.identity.serial,
                "axes": [one._asdict() for one in found.found],
                "page": text,
            }
        )
    else:
        _print_found(found, file, text, dry_run)


def _leader(total: int) -> Lead:
    number = 0

    def lead(step: Step) -> None:
        nonlocal number
        number += 1
        typer.prompt(
            f"{number} of {total}: {step.instruction}; press Enter and stay so for a second",
            default="",
            show_default=False,
            err=True,
        )

    return lead


def _print_found(found: Calibration, file: Path, text: str, dry_run: bool) -> None:
    rows = [
        (one.axis, one.moved_by, one.low, one.centre, one.high, one.sign,
         f"{one.noise:.1%}", f"{one.dead_zone:.1%}")
        for one in found.found
    ]  # fmt: skip
    columns = ("axis", "moved by", "low", "rest", "high", "sign", "noise", "dead zone")
    print_table(found.device.calibrated, columns, rows)
    print_line(text if dry_run else f"wrote {file}")

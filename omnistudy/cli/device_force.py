"""`omnistudy device calibrate --force`: leads through the steps while an instrument is read."""

from __future__ import annotations

import os
import select
import sys
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import typer

from omnistudy.cli.device_chosen import chosen_port, stick_line
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.devices import Device
    from omnistudy.devices.stick.force_calibration import ForceCalibration
    from omnistudy.devices.stick.force_fit import Reading

UNITS = ("N", "N", "N·m")


class ForceOptions(NamedTuple):
    """What the verb was told: see its help."""

    instrument: str
    who: str
    greatest: int
    levels: int
    readings: Path | None


def measure_forces(
    given: str, page: str, options: ForceOptions, replace: bool, dry_run: bool, json: bool
) -> None:
    """Measure or read forces, fit them and write the stick's page; see the verb."""
    from datetime import date

    from omnistudy.devices.handheld.calibrating import write_page
    from omnistudy.devices.stick.force_calibration import ForceCalibration
    from omnistudy.devices.stick.force_page import fitted, page_of
    from omnistudy.lab import default_folder

    if not options.instrument:
        raise typer.BadParameter("--instrument says what was read, such as 'Kern FCB, ±0.02 N'")
    device = _stick(given)
    file = default_folder() / "device" / f"{page}.yaml"
    if file.exists() and not (replace or dry_run):
        typer.confirm(f"{file} is there: replace it?", abort=True, err=True)
    serial, readings = _readings(given, options, file.with_suffix(".csv"), dry_run)
    x, y, theta = fitted(readings)
    calibration = ForceCalibration(
        date=date.today(), who=options.who, instrument=options.instrument, serial=serial,
        x=x, y=y, theta=theta,
    )  # fmt: skip
    text = page_of(device, calibration, given)
    if not dry_run:
        write_page(file, text)
    if json:
        print_json({"written": not dry_run, "file": file, "calibration": calibration, "page": text})
    else:
        _print_found(calibration, text if dry_run else f"wrote {file}")


def _stick(given: str) -> Device:
    """Give the stick of a page or a port; raises NoForceToCalibrate."""
    from omnistudy.devices.emulated_stick import EmulatedStickDevice
    from omnistudy.devices.serial_stick import SerialStickDevice
    from omnistudy.errors.force_calibration import NoForceToCalibrate
    from omnistudy.session.parts import part

    if "/" in given:
        return SerialStickDevice(port=given)
    device: Device = part("device", given)
    if not isinstance(device, SerialStickDevice | EmulatedStickDevice):
        raise NoForceToCalibrate(given)
    return device


def _readings(
    given: str, options: ForceOptions, kept: Path, dry_run: bool
) -> tuple[str, list[Reading]]:
    """Give the stick's serial number, "" when no stick was asked, and the readings."""
    from omnistudy.devices.stick.force_page import read_readings, write_readings
    from omnistudy.errors.force_calibration import PortNeeded

    if options.readings:
        return "", read_readings(options.readings)
    port = chosen_port(given)
    if port is None:
        raise PortNeeded(given)
    serial, readings = _measured(port, options)
    if not dry_run:
        kept.parent.mkdir(parents=True, exist_ok=True)
        write_readings(kept, readings)
    return serial, readings


def _measured(port: str, options: ForceOptions) -> tuple[str, list[Reading]]:
    from omnistudy.devices.stick.check import wait_for_telemetry
    from omnistudy.devices.stick.force_steps import Plan, measure

    plan = Plan(options.greatest, options.levels)
    typed = Typed(plan.total())
    _tell(
        "Fix the handle to the instrument so that it cannot move; of theta, read the torque. "
        f"{plan.total()} steps of force come, up to {plan.greatest} PWM steps either way. For "
        "each, type what the instrument says while the force is there: positive is a push "
        "forward, to the left, counter-clockwise. Hold the dead-man's switch all the time; "
        "letting go ends it. Press Enter to begin."
    )
    typed.line()
    with stick_line(port) as line:
        wait_for_telemetry(line)
        return str(line.identify().serial), measure(line, [typed] * 3, plan, typed.tell)


class Typed:
    """A person who reads the instrument and types; asked without waiting, as force is on."""

    def __init__(self, total: int) -> None:
        self._total = total
        self._number = 0
        self._prompt = ""
        self._rest = ""

    def tell(self, axis: int, duty: int) -> None:
        """Note which step comes; it is asked for when its force has settled."""
        from omnistudy.devices.stick.force_steps import AXES

        self._number += 1
        self._prompt = (
            f"{self._number} of {self._total}: {AXES[axis]}, {duty:+d} PWM steps; {UNITS[axis]}:"
        )

    def __call__(self) -> float | None:
        """Give what was typed; None while nothing, or no number, was."""
        if self._prompt:
            _tell(self._prompt)
            self._prompt = ""
        readable, _, _ = select.select((sys.stdin,), (), (), 0)
        if readable:
            self._take()
        if "\n" not in self._rest:
            return None
        text = self.line()
        try:
            return float(text.replace(",", "."))
        except ValueError:
            _tell(f"'{text}' is no number; type it again:")
            return None

    def line(self) -> str:
        """Wait for a line; raises Abort at the end of input."""
        while "\n" not in self._rest:
            self._take()
        text, _, self._rest = self._rest.partition("\n")
        return text.strip()

    def _take(self) -> None:
        """Take what was typed past Python's buffer, which `select` cannot see."""
        typed = os.read(sys.stdin.fileno(), 4096)
        if not typed:
            raise typer.Abort
        self._rest += typed.decode(errors="replace")


def _tell(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _print_found(calibration: ForceCalibration, last: str) -> None:
    rows = [
        (name, unit, one.per_duty, f"± {one.per_duty_95 / one.per_duty:.1%}", one.dead_band,
         one.offset, f"± {one.prediction_95:.3g}", one.readings)
        for name, unit, one in zip(("x", "y", "theta"), UNITS, calibration.axes, strict=True)
    ]  # fmt: skip
    columns = ("axis", "unit", "a PWM step", "95 %", "dead band", "zero", "a reading", "readings")
    print_table(f"Force calibration {calibration.name}", columns, rows)
    print_line(last)

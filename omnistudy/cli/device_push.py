"""`omnistudy device calibrate --force` of a bought stick: push, read, type."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from omnistudy.cli.device_chosen import hardware_of
from omnistudy.cli.output import print_json, print_line

if TYPE_CHECKING:
    from omnistudy.devices.handheld.force_scale import Push

WAYS = (("back", "forward"), ("right", "left"))


def measure_pushes(
    given: str, page: str, levels: int, instrument: str, replace: bool, dry_run: bool, json: bool
) -> None:
    """Measure a full effect in newtons and write the stick's page; see the verb."""
    from omnistudy.devices.handheld.calibrating import page_text, write_page
    from omnistudy.devices.handheld.measuring_force import measure_force
    from omnistudy.lab import default_folder

    if not instrument:
        raise typer.BadParameter("--instrument says what was read, such as 'spring scale, ±0.1 N'")
    device = hardware_of(given, "calibrate the force of")
    file = default_folder() / "device" / f"{page}.yaml"
    if file.exists() and not (replace or dry_run):
        typer.confirm(f"{file} is there: replace it?", abort=True, err=True)
    found = measure_force(device, levels, instrument, _lead, _read)
    strength = found.device.rendered
    assert strength is not None
    text = page_text(found.device, f"{given}, its force measured {strength.measured}")
    if not dry_run:
        write_page(file, text)
    if json:
        print_json({"written": not dry_run, "file": file, **found.found._asdict(), "page": text})
        return
    turned = ", pushes turned round" if found.found.turned else ""
    print_line(f"a full effect is {strength.force:g} N{turned}: {strength.measured}")
    print_line(text if dry_run else f"wrote {file}")


def _told(push: Push) -> str:
    axis, share = push
    way = WAYS[axis][share > 0] if share else "nowhere"
    return f"{'xy'[axis]}, {abs(share):.0%} {way}"


def _lead(push: Push) -> None:
    from omnistudy.devices.handheld.measuring_force import PUSH_S

    typer.prompt(
        f"{_told(push)}: fix the handle to the instrument, press Enter, and read it while it "
        f"pushes for {PUSH_S:g} s",
        default="", show_default=False, err=True,
    )  # fmt: skip


def _read(push: Push) -> float:
    number: float = typer.prompt(
        f"what was read of {_told(push)}, N; forward and left are positive", type=float, err=True
    )
    return number

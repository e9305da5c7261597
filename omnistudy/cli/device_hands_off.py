"""`omnistudy device check --force` and `familiarise`: a stick with our firmware gets force."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

import typer

from omnistudy.cli.device_chosen import stick_line

if TYPE_CHECKING:
    from omnistudy.devices.serial_stick import SerialStickDevice
    from omnistudy.devices.stick.check import Finding


def find_before_force(given: str | None) -> tuple[Finding, ...]:
    """Lead through the checks before force; each sentence goes to the standard error."""
    from omnistudy.devices.stick.checks import check_before_force

    device = _stick(given, "check with --force")
    with stick_line(device.port) as line:
        return check_before_force(line, device.stick.stops, _tell).findings


def find_own_ceiling(
    given: str | None, page: str, replace: bool, dry_run: bool, json: bool
) -> None:
    """Find somebody's ceiling and write a page of the stick with it; see the verb."""
    from omnistudy.cli.output import print_json, print_line
    from omnistudy.devices.handheld.calibrating import write_page
    from omnistudy.devices.stick.check import wait_for_telemetry
    from omnistudy.devices.stick.conversion import handle_scale
    from omnistudy.devices.stick.familiarise import find_ceiling
    from omnistudy.lab import default_folder

    device = _stick(given, "familiarise with")
    file = default_folder() / "device" / f"{page}.yaml"
    if file.exists() and not (replace or dry_run):
        typer.confirm(f"{file} is there: replace it?", abort=True, err=True)
    per_duty = handle_scale(device.stick, device.calibration).per_duty
    with stick_line(device.port) as line:
        wait_for_telemetry(line)
        ceiling = find_ceiling(line, per_duty, device.ceiling, _tell)
    text = _page_of(device.model_copy(update={"ceiling": ceiling}), given or "serial_stick")
    if not dry_run:
        write_page(file, text)
    if json:
        print_json({"written": not dry_run, "file": file, "ceiling": ceiling, "page": text})
    else:
        print_line(f"{ceiling.x:.2f} N in x, {ceiling.y:.2f} N in y, {ceiling.theta:.2f} N·m")
        print_line(text if dry_run else f"wrote {file}")


def _page_of(device: SerialStickDevice, origin: str) -> str:
    """Give the YAML page of a stick that says what was given or found."""
    import yaml

    tree: dict[str, Any] = device.model_dump(mode="json", include=device.model_fields_set)
    tree.pop("kind", None)
    tree["ceiling"] = {axis: round(force, 3) for axis, force in device.ceiling}
    body = yaml.safe_dump(tree, sort_keys=False, allow_unicode=True)
    return f"kind: {device.kind}  # {origin}, with somebody's own ceiling\n{body}"


def _stick(given: str | None, verb: str) -> SerialStickDevice:
    """Give the stick of a port or a page; raises UnknownPart, BrokenPart, NoSuchDevice."""
    from omnistudy.devices.serial_stick import SerialStickDevice
    from omnistudy.errors.handheld import NoSuchDevice
    from omnistudy.session.parts import part

    if given is None:
        return SerialStickDevice()
    if "/" in given:
        return SerialStickDevice(port=given)
    device = part("device", given)
    if not isinstance(device, SerialStickDevice):
        raise NoSuchDevice(device.kind, verb)
    return device


def _tell(sentence: str) -> None:
    print(sentence, file=sys.stderr, flush=True)

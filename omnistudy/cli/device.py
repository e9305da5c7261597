"""`omnistudy device`: what can be held, what is plugged in, and what that says."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.kind_verbs import Present, Recorded, add_list_and_show
from omnistudy.cli.output import print_json, print_table

if TYPE_CHECKING:
    from omnistudy.devices import Device
    from omnistudy.devices.stick.check import Finding
    from omnistudy.devices.stick.emulator import EmulatedStick

app = typer.Typer(no_args_is_help=True)


def _channels(device: Device) -> list[Recorded]:
    from omnistudy.channel import Recording

    running = device.connect(Recording().physics_hz)
    channels = (*running.axes, *running.channels)
    return [(one.name, one.unit, one.description) for one in channels]


def _plugged_in() -> Present:
    from omnistudy.devices.handheld.plugged_in import plugged_in

    found = plugged_in()
    return Present(
        "Plugged in",
        "plugged_in",
        ("kind", "name", "serial", "path"),
        found.attached,
        [f"not looked for: {reason}" for reason in found.unseen],
    )


add_list_and_show(app, "device", "gamepad", _channels, _plugged_in)


def _ports() -> list[str]:
    from omnistudy.devices.stick.serial_port import attached_ports

    return list(attached_ports())


def _pages() -> list[str]:
    from omnistudy.session.parts import part_names

    return list(part_names("device"))


def _ports_and_pages() -> list[str]:
    return [*_ports(), *_pages()]


DeviceOrPort = Annotated[
    str | None,
    typer.Argument(
        metavar="[DEVICE|PORT]",
        help="A page such as gamepad, or a stick's serial port such as /dev/ttyACM0; the only "
        "port unless given.",
        autocompletion=_ports_and_pages,
    ),
]
Seconds = Annotated[float, typer.Option(help="How long; 0 is until Ctrl-C.", min=0.0)]


@app.command()
def check(
    device: DeviceOrPort = None,
    force: Annotated[
        bool,
        typer.Option("--force", help="Lead through the checks before force; the stick moves."),
    ] = False,
    json: AsJson = False,
) -> None:
    """Look a device over while nobody touches it, without giving it force.

    Of a stick with our firmware: firmware, settings, telemetry, faults, contacts. Of any other:
    which one it is, what it tells, whether it rests. Says what real time this system gives.

    With --force a stick with our firmware is checked as before every session: switches, signs,
    zero, centring. You are told what to press; then keep your hands off, it moves to its stops.

    Exits 1 when something is not as it should be; a WARN is no such thing.

    Example: omnistudy device check gamepad

    Example: omnistudy device check /dev/ttyACM0 --force
    """
    from omnistudy.cli.device_chosen import chosen_port, hardware_of, stick_line

    port = None if force else chosen_port(device)
    if force:
        from omnistudy.cli.device_hands_off import find_before_force

        findings = find_before_force(device)
    elif port is None:
        from omnistudy.devices.handheld.check import check_handheld

        findings = check_handheld(hardware_of(device, "check"))
    else:
        from omnistudy.devices.stick.check import check_stick

        with stick_line(port) as line:
            findings = check_stick(line)
    _print_findings(findings, json)
    if not all(finding.sound for finding in findings):
        raise typer.Exit(1)


def _print_findings(findings: tuple[Finding, ...], json: bool) -> None:
    from omnistudy.devices.real_time import real_time_means

    missing = real_time_means().missing
    rows = [(one.what, one.found, "ok" if one.sound else "LOOK AT THIS") for one in findings]
    rows.append(("real time", missing or "to be had", "WARN" if missing else "ok"))
    if json:
        said = [{**one._asdict(), "warning": False} for one in findings]
        print_json(
            [*said, {"what": "real time", "found": rows[-1][1], "sound": True,
                     "warning": bool(missing)}]
        )  # fmt: skip
    else:
        print_table("", ("what", "found", ""), rows)


@app.command()
def monitor(device: DeviceOrPort = None, seconds: Seconds = 0.0, json: AsJson = False) -> None:
    """Print ten times a second where a device is and what it tells, without giving it force.

    Shows how the axes and buttons of a gamepad or stick are called, and which of them move.

    Example: omnistudy device monitor gamepad --seconds 10
    """
    from omnistudy.cli.device_chosen import chosen_port, hardware_of
    from omnistudy.cli.device_monitor import watch_hardware, watch_stick

    port = chosen_port(device)
    if port is None:
        watch_hardware(hardware_of(device, "watch"), seconds, json)
    else:
        watch_stick(port, seconds, json)


@app.command()
def calibrate(
    device: Annotated[
        str,
        typer.Argument(
            help="A page such as gamepad; with --force also a stick's serial port.",
            autocompletion=_ports_and_pages,
        ),
    ],
    force: Annotated[
        bool, typer.Option("--force", help="Find what its motors push, with an instrument.")
    ] = False,
    instrument: Annotated[
        str, typer.Option(help="With --force: what is read, and how exact it is.")
    ] = "",
    who: Annotated[str, typer.Option(help="With --force: initials of who reads, or nothing.")] = "",
    greatest: Annotated[
        int, typer.Option(help="With --force: PWM steps of the greatest push.", min=2, max=255)
    ] = 200,
    levels: Annotated[
        int, typer.Option(help="With --force: sizes of push either way.", min=2, max=20)
    ] = 4,
    readings: Annotated[
        Path | None,
        typer.Option(
            help="With --force: a CSV file (axis, duty, force) to use instead of measuring.",
            exists=True,
            dir_okay=False,
        ),
    ] = None,
    page: Annotated[
        str | None,
        typer.Option(help="Name of the page that is written; DEVICE, or stick, unless given."),
    ] = None,
    replace: Annotated[
        bool, typer.Option("--replace", help="Replace the lab's page without asking.")
    ] = False,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Print the page, and write nothing.")
    ] = False,
    json: AsJson = False,
) -> None:
    """Find rest, ends, direction and noise of every axis, and write a page into the lab's folder.

    Leads through each step; the device gives no force. The folder is the one of --conf or
    OMNISTUDY_CONF, else ./lab. A page of the same name comes before ours.

    With --force it pushes: a stick with our firmware takes steps of PWM against a load cell or a
    spring scale, and what is read becomes newtons a step, with their uncertainty and a dead band.
    A bought force-feedback stick pushes for three seconds at a time, and you type what was read.

    Example: omnistudy device calibrate gamepad --dry-run

    Example: omnistudy device calibrate serial_stick --force --instrument 'load cell, ±0.02 N'
    """
    from omnistudy.cli.device_calibrate import find_ranges
    from omnistudy.cli.device_chosen import is_bought
    from omnistudy.cli.device_force import ForceOptions, measure_forces
    from omnistudy.cli.device_push import measure_pushes

    if force and is_bought(device):
        measure_pushes(device, page or device, levels, instrument, replace, dry_run, json)
        return
    if force:
        options = ForceOptions(instrument, who, greatest, levels, readings)
        name = page or ("stick" if "/" in device else device)
        measure_forces(device, name, options, replace, dry_run, json)
        return
    find_ranges(device, page or device, replace, dry_run, json)


@app.command()
def familiarise(
    page: Annotated[str, typer.Option(help="Name of the page that is written, such as P01.")],
    device: DeviceOrPort = None,
    replace: Annotated[
        bool, typer.Option("--replace", help="Replace the lab's page without asking.")
    ] = False,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Print the page, and write nothing.")
    ] = False,
    json: AsJson = False,
) -> None:
    """Find the greatest force that somebody wants to meet, and write a page of the stick with it.

    A force rises on each axis until the person lets go of the dead-man's switch, never above the
    ceiling of the page that was given. Four fifths of it becomes the ceiling. The folder is the one
    of --conf or OMNISTUDY_CONF, else ./lab.

    Example: omnistudy device familiarise /dev/ttyACM0 --page P01
    """
    from omnistudy.cli.device_hands_off import find_own_ceiling

    find_own_ceiling(device, page, replace, dry_run, json)


@app.command()
def emulate(
    hand: Annotated[bool, typer.Option(help="Let a relaxed hand hold the stick.")] = False,
    estop: Annotated[bool, typer.Option(help="Begin with the emergency stop pressed.")] = False,
    seconds: Seconds = 0.0,
) -> None:
    """Run the firmware on an emulated board behind a pseudo-terminal, in step with wall time.

    Prints the port's name, which every program can open as a stick. Needs avr-gcc and
    libsimavr-dev.

    Example: omnistudy device emulate --hand
    """
    import time

    from omnistudy.devices.stick.emulator import EmulatedStick
    from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal

    board = EmulatedStick()
    board.press_estop(estop)
    board.hold_dead_man(True)
    board.release()
    if hand:
        _hold(board)
    terminal = PseudoTerminal(board)
    print(terminal.path, flush=True)
    end = time.monotonic() + (seconds or float("inf"))
    try:
        terminal.keep_pace(lambda: time.monotonic() >= end)
    finally:
        terminal.close()


def _hold(board: EmulatedStick) -> None:
    from omnistudy.devices.stick.emulator import RELAXED_HAND

    for axis, grip in enumerate(RELAXED_HAND):
        board.hold(axis, *grip)

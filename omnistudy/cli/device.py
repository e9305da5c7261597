"""`omnistudy device`: what can be held, and what a stick on its serial line says."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.kind_verbs import Recorded, add_list_and_show
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.devices import Device
    from omnistudy.devices.stick.emulator import EmulatedStick
    from omnistudy.devices.stick.line import StickLine

app = typer.Typer(no_args_is_help=True)


def _channels(device: Device) -> list[Recorded]:
    from omnistudy.channel import Recording

    running = device.connect(Recording().physics_hz)
    channels = (*running.axes, *running.channels)
    return [(one.name, one.unit, one.description) for one in channels]


add_list_and_show(app, "device", "simulated_stick", _channels)


def _ports() -> list[str]:
    from omnistudy.devices.stick.serial_port import attached_ports

    return list(attached_ports())


PortArgument = Annotated[
    str | None,
    typer.Argument(
        help="Serial port of the stick, such as /dev/ttyACM0; the only one unless given.",
        autocompletion=_ports,
    ),
]


@contextmanager
def _line(port: str | None) -> Iterator[StickLine]:
    from omnistudy.devices.stick.line import StickLine
    from omnistudy.devices.stick.serial_port import SerialPort, only_port

    transport = SerialPort(port or only_port())
    try:
        yield StickLine(transport)
    finally:
        transport.close()


@app.command()
def check(port: PortArgument = None, json: AsJson = False) -> None:
    """Look a stick over without giving it force: firmware, settings, telemetry, faults, contacts.

    Exits 1 when something is not as it should be.

    Example: omnistudy device check /dev/ttyACM0
    """
    from omnistudy.devices.stick.check import check_stick

    with _line(port) as line:
        findings = check_stick(line)
    if json:
        print_json([finding._asdict() for finding in findings])
    else:
        rows = [(one.what, one.found, "ok" if one.sound else "LOOK AT THIS") for one in findings]
        print_table("", ("what", "found", ""), rows)
    if not all(finding.sound for finding in findings):
        raise typer.Exit(1)


@app.command()
def monitor(
    port: PortArgument = None,
    seconds: Annotated[float, typer.Option(help="How long; 0 is until Ctrl-C.", min=0.0)] = 0.0,
    json: AsJson = False,
) -> None:
    """Print ten times a second where a stick is, how fast, what its motors do and its faults.

    Example: omnistudy device monitor /dev/ttyACM0 --seconds 10
    """
    from omnistudy.devices.stick.check import wait_for_telemetry
    from omnistudy.devices.stick.messages import Fault, State

    with _line(port) as line:
        wait_for_telemetry(line)
        end = line.transport.now() + (seconds or float("inf"))
        while line.transport.now() < end:
            heard = line.listen(0.1)
            if not heard:
                print_line("nothing was heard for 0.1 s")
            elif json:
                print_json(heard[-1]._asdict())
            else:
                last = heard[-1]
                print_line(
                    f"{last.tick / 1000:9.1f} s  counts {last.position}  PWM {last.motor}  "
                    f"{State(last.state).name}  {Fault(last.faults).name or 'no fault'}"
                )


@app.command()
def emulate(
    hand: Annotated[bool, typer.Option(help="Let a relaxed hand hold the stick.")] = False,
    estop: Annotated[bool, typer.Option(help="Begin with the emergency stop pressed.")] = False,
    seconds: Annotated[float, typer.Option(help="How long; 0 is until Ctrl-C.", min=0.0)] = 0.0,
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

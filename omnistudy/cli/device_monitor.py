"""`omnistudy device monitor`: a line ten times a second."""

from __future__ import annotations

from typing import TYPE_CHECKING

from omnistudy.cli.device_chosen import stick_line
from omnistudy.cli.output import print_json, print_line

if TYPE_CHECKING:
    from omnistudy.devices.handheld.handheld import Handheld, RunningHandheld

PERIOD_S = 0.1


def watch_stick(port: str, seconds: float, json: bool) -> None:
    """Print what a stick with our firmware tells."""
    from omnistudy.devices.stick.check import wait_for_telemetry
    from omnistudy.devices.stick.messages import Fault, State

    with stick_line(port) as line:
        wait_for_telemetry(line)
        end = line.transport.now() + (seconds or float("inf"))
        while line.transport.now() < end:
            heard = line.listen(PERIOD_S)
            if not heard:
                print_line(f"nothing was heard for {PERIOD_S:g} s")
            elif json:
                print_json(heard[-1]._asdict())
            else:
                last = heard[-1]
                print_line(
                    f"{last.tick / 1000:9.1f} s  counts {last.position}  PWM {last.motor}  "
                    f"{State(last.state).name}  {Fault(last.faults).name or 'no fault'}"
                )


def watch_hardware(device: Handheld, seconds: float, json: bool) -> None:
    """Print where a bought device is, and which of its axes and buttons are off their rest."""
    import time

    from omnistudy.devices import NO_HAND

    running = device.connect(device.tick_hz)
    turns = round(PERIOD_S * device.tick_hz)
    try:
        began = time.monotonic()
        while not seconds or time.monotonic() - began < seconds:
            for _ in range(turns):
                state = running.advance(NO_HAND)
                time.sleep(1.0 / device.tick_hz)
            _print_state(running, time.monotonic() - began, state.position, json)
    finally:
        running.close()


def _print_state(
    running: RunningHandheld, elapsed: float, position: tuple[float, ...], json: bool
) -> None:
    hardware = running.hardware
    told = list(zip(hardware.axes, running.raw, strict=True))
    trouble = running.trouble()
    if json:
        names = [channel.name for channel in running.axes]
        print_json(
            {
                "elapsed": elapsed,
                **dict(zip(names, position, strict=True)),
                "tells": {axis.name: raw for axis, raw in told},
                "trouble": trouble,
            }
        )
        return
    x, y, theta = position
    off = [f"{axis.name} {raw:g}" for axis, raw in told if raw != axis.centre]
    print_line(
        f"{elapsed:7.1f} s  x {x:+.4f} m  y {y:+.4f} m  theta {theta:+.3f} rad  "
        f"{trouble or ', '.join(off) or 'all at rest'}"
    )

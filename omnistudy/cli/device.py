"""`omnistudy device`: what can be held, with its numbers and what it records."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from omnistudy.cli.kind_verbs import Recorded, add_list_and_show

if TYPE_CHECKING:
    from omnistudy.devices import Device

app = typer.Typer(no_args_is_help=True)


def _channels(device: Device) -> list[Recorded]:
    from omnistudy.channel import Recording

    running = device.connect(Recording().physics_hz)
    channels = (*running.axes, *running.channels)
    return [(one.name, one.unit, one.description) for one in channels]


add_list_and_show(app, "device", "simulated_stick", _channels)

"""`omnistudy plant`: what robots there are, with their numbers and what they record."""

from __future__ import annotations

from typing import TYPE_CHECKING

import typer

from omnistudy.cli.kind_verbs import Recorded, add_list_and_show

if TYPE_CHECKING:
    from omnistudy.plants import Plant

app = typer.Typer(no_args_is_help=True)


def _channels(plant: Plant) -> list[Recorded]:
    from omnistudy.channel import Recording
    from omnistudy.geometry import PlanarPose
    from omnistudy.scene import Scene

    running = plant.build(Scene(bodies=()), PlanarPose(0.0, 0.0, 0.0), Recording().physics_hz, "")
    try:
        return [(one.name, one.unit, one.description) for one in running.channels]
    finally:
        running.close()


add_list_and_show(app, "plant", "youbot", _channels)

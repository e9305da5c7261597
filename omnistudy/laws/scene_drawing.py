"""What a law does in one scene, drawn as the thesis drew it (Tyagi 2017, App. B)."""

from __future__ import annotations

from math import pi
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from omnistudy.geometry import ZERO_MATRIX, PlanarPose, PlanarTwist, PlanarWrench, Scan
from omnistudy.laws.boundary import Boundary, RectangularBoundary
from omnistudy.laws.drawing import CLOCKWISE, COUNTER_CLOCKWISE, NEWTONS_PER_METRE_DRAWN, outline
from omnistudy.laws.law import Law, Sensed
from omnistudy.laws.picture import picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

RAY = "#8ecae6"
FRONT_RAY = "#5fb878"
"""Rays light blue, those of the front sector green."""
FORCE_X, FORCE_Y, RESULTANT = "#2a9d4b", "#1d4ed8", "#6b7280"
FRONT = 33.75 * pi / 180.0
"""Half the front sector: rays 52 to 76 of 128."""
TORQUE_RADIUS = 0.12
"""m, of the arc that shows the torque."""
FULL_TORQUE = 4.4
"""N·m that is drawn as half a turn: what the stick can give."""
ROBOT = RectangularBoundary(layer_x=0.0, layer_y=0.0)
CENTRE = PlanarPose(0.0, 0.0, 0.0)


def draw_scene(law: Law, scan: Scan, path: Path, replace: bool = False) -> None:
    """Draw rays, boundary, hit points and the wrench on a robot that stands still, facing up.

    Raises UnknownPictureFormat or PictureExists.
    """
    wrench = law.field(Sensed(scan, PlanarTwist(0.0, 0.0, 0.0), ZERO_MATRIX)).wrench
    with picture(path, replace) as figure:
        figure.set_size_inches(6.0, 6.8)
        axes = figure.subplots()
        axes.set(
            aspect="equal",
            xlabel="x in m, forward",
            ylabel="y in m, left",
            title=f"law '{law.kind}': fx {wrench.fx:.2f} N, fy {wrench.fy:.2f} N, "
            f"tau {wrench.tau:.2f} N·m",
        )
        _draw_rays(axes, scan)
        outline(axes, ROBOT, CENTRE, "black")
        boundary = getattr(law, "boundary", None)
        if isinstance(boundary, Boundary):
            outline(axes, boundary, CENTRE, "0.55", "--")
        _draw_wrench(axes, wrench)
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.1), ncols=3, frameon=False)
        axes.title.set_fontsize(9.0)


def _draw_rays(axes: Axes, scan: Scan) -> None:
    hit = (scan.ranges > 0.0) & (scan.ranges < scan.max_range)
    length = np.where(hit, scan.ranges, scan.max_range)
    x, y = length * np.cos(scan.angles), length * np.sin(scan.angles)
    front = np.abs((scan.angles + pi) % (2.0 * pi) - pi) <= FRONT
    for ahead, colour in ((False, RAY), (True, FRONT_RAY)):
        chosen = front == ahead
        rays = (
            np.stack([np.zeros(chosen.sum()), x[chosen]]),
            np.stack([np.zeros(chosen.sum()), y[chosen]]),
        )
        axes.plot(*rays, color=colour, linewidth=0.6, alpha=0.7)
    axes.plot(x[hit], y[hit], "o", color="black", markersize=3, label="hit")


def _draw_wrench(axes: Axes, wrench: PlanarWrench) -> None:
    parts = (
        ("Fx", wrench.fx, 0.0, FORCE_X),
        ("Fy", 0.0, wrench.fy, FORCE_Y),
        ("force", wrench.fx, wrench.fy, RESULTANT),
    )
    for name, fx, fy, colour in parts:
        axes.quiver(
            0.0,
            0.0,
            fx,
            fy,
            color=colour,
            angles="xy",
            scale_units="xy",
            scale=NEWTONS_PER_METRE_DRAWN,
            width=0.008,
            zorder=5,
            label=f"{name} (1 m is {NEWTONS_PER_METRE_DRAWN:g} N)" if name == "force" else name,
        )
    if wrench.tau == 0.0:
        return
    turn = np.linspace(0.0, pi * max(-1.0, min(1.0, wrench.tau / FULL_TORQUE)), 60)
    axes.plot(
        TORQUE_RADIUS * np.cos(turn),
        TORQUE_RADIUS * np.sin(turn),
        color=COUNTER_CLOCKWISE if wrench.tau > 0.0 else CLOCKWISE,
        linewidth=3,
        zorder=6,
        label=f"torque, {'counter-clockwise' if wrench.tau > 0.0 else 'clockwise'}",
    )

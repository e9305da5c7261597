"""What laws do in one scene: the scan, what reaches into the boundary, the wrench on the hand."""

from __future__ import annotations

from collections.abc import Sequence
from math import ceil, hypot
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from omnistudy.geometry import PlanarPose, Scan
from omnistudy.laws.law import Law
from omnistudy.laws.probe import Probe, touching
from omnistudy.laws.robot_drawing import CLOCKWISE, COUNTER_CLOCKWISE, INK, draw_robot
from omnistudy.laws.shown import shown, stick_shown
from omnistudy.pictures import picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

ALONG_X = "#2b8a3e"
ALONG_Y = "#1864ab"
"""Green along x and blue along y, as the thesis drew them (appendix B)."""

DEPTH = "#e8590c"

NEWTONS_PER_METRE_DRAWN = 40.0
"""An arrow of 1 m in the picture is this force."""

LEAST_DRAWN = 1e-3
"""N or N·m below which a part gets no arrow."""

ARC_RADIUS = 0.13
ARC_PER_NEWTON_METRE = 0.35
"""rad of arc for one N·m, within what stays readable."""
SHORTEST_ARC, LONGEST_ARC = 0.5, 4.5

SHOWN_AROUND = 0.75
"""m to each side of the robot that are always in the picture."""

ALONE, BESIDE_OTHERS = 6.0, 4.5
"""Inches of the picture of one law, and of each of several."""

COLUMNS = 3
"""Laws side by side before a new row begins."""


def draw_scene(laws: Sequence[Law], scan: Scan, path: Path, replace: bool = False) -> None:
    """Draw what the scan saw, what reaches into the boundary, and force and torque on the hand.

    Several laws are drawn side by side. Raises UnknownPictureFormat, PictureExists or NoForce.
    """
    with picture(path, replace) as figure:
        columns = min(len(laws), COLUMNS)
        rows = ceil(len(laws) / columns)
        size = ALONE if len(laws) == 1 else BESIDE_OTHERS
        figure.set_size_inches(size * columns, size * rows)
        panels = figure.subplots(rows, columns, squeeze=False).ravel()
        for axes, law in zip(panels, laws, strict=False):
            _draw_panel(axes, law, scan)
        for axes in panels[len(laws) :]:
            axes.set_axis_off()


def _draw_panel(axes: Axes, law: Law, scan: Scan) -> None:
    found = shown(law, scan)
    axes.set(xlim=(-SHOWN_AROUND, SHOWN_AROUND), ylim=(-SHOWN_AROUND, SHOWN_AROUND))
    axes.set(aspect="equal", xlabel="x in m, ahead", ylabel="y in m, left")
    axes.set_title(_title(found, stick_shown(law)), color=INK, fontsize=10.0)
    draw_robot(axes, law, PlanarPose(0.0, 0.0, 0.0))
    _draw_seen(axes, scan)
    _draw_depths(axes, law, scan)
    _draw_forces(axes, found)
    _draw_torque(axes, found.tau)
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc="lower left", fontsize=8.0, frameon=False)


def _title(found: Probe, stick: str) -> str:
    wrench = f"Fx {found.fx:+.2f} N, Fy {found.fy:+.2f} N, torque {found.tau:+.2f} N·m"
    count = {None: "", 1: ": 1 ray touches the boundary"}
    rays = count.get(found.n, f": {found.n} rays touch the boundary")
    return f"law '{found.kind}'{rays}{stick}\n{wrench}"


def _draw_seen(axes: Axes, scan: Scan) -> None:
    met = (scan.ranges > 0.0) & (scan.ranges < scan.max_range)
    axes.plot(*scan.points()[met].T, "o", color=INK, markersize=3.5, zorder=4)


def _draw_depths(axes: Axes, law: Law, scan: Scan) -> None:
    """Draw a line from what each ray met out to the boundary."""
    found = touching(law, scan)
    if found is None:
        return
    angles = scan.angles[found.rays]
    met = scan.points()[found.rays]
    out = met + (found.depth * np.array((np.cos(angles), np.sin(angles)))).T
    axes.plot(*np.stack((met, out)).transpose(2, 0, 1), color=DEPTH, linewidth=1.2, zorder=3)
    axes.plot([], [], color=DEPTH, linewidth=1.2, label="inside the boundary")


def _draw_forces(axes: Axes, found: Probe) -> None:
    parts = (
        (found.fx, found.fy, "#868e96", 3.5, "force on the hand"),
        (found.fx, 0.0, ALONG_X, 1.8, "Fx"),
        (0.0, found.fy, ALONG_Y, 1.8, "Fy"),
    )
    for fx, fy, colour, width, name in parts:
        if hypot(fx, fy) < LEAST_DRAWN:
            continue
        tip = fx / NEWTONS_PER_METRE_DRAWN, fy / NEWTONS_PER_METRE_DRAWN
        _arrow(axes, (0.0, 0.0), tip, colour, width)
        axes.plot([], [], color=colour, linewidth=width, label=name)


def _draw_torque(axes: Axes, tau: float) -> None:
    if abs(tau) < LEAST_DRAWN:
        return
    colour = COUNTER_CLOCKWISE if tau > 0.0 else CLOCKWISE
    turn = np.clip(ARC_PER_NEWTON_METRE * abs(tau), SHORTEST_ARC, LONGEST_ARC)
    angles = np.copysign(np.linspace(0.0, turn, 90), tau)
    x, y = ARC_RADIUS * np.cos(angles), ARC_RADIUS * np.sin(angles)
    way = "counter-clockwise" if tau > 0.0 else "clockwise"
    axes.plot(x, y, color=colour, linewidth=2.2, label=f"torque, {way}", zorder=5)
    _arrow(axes, (x[-2], y[-2]), (x[-1], y[-1]), colour, 2.2)


def _arrow(
    axes: Axes, start: tuple[float, float], tip: tuple[float, float], colour: str, width: float
) -> None:
    axes.annotate(
        "",
        xy=tip,
        xytext=start,
        arrowprops={
            "arrowstyle": "-|>,head_width=0.25,head_length=0.5",
            "color": colour,
            "linewidth": width,
            "shrinkA": 0.0,
            "shrinkB": 0.0,
        },
        zorder=5,
    )

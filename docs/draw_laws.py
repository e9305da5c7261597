"""Write the pictures of docs/laws.md: `python docs/draw_laws.py [FOLDER]`."""

from __future__ import annotations

import sys
from math import degrees, pi
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from omnistudy.geometry import PlanarPose
from omnistudy.geometry.ray_casting import Segment, cast
from omnistudy.laws import Law
from omnistudy.laws.drawing import draw_field
from omnistudy.laws.none import NoLaw
from omnistudy.laws.robot_drawing import INK, draw_robot
from omnistudy.laws.shown import shown
from omnistudy.laws.standard_scenes import MAX_RANGE, RAYS
from omnistudy.pictures import picture
from omnistudy.registry import load_kind

if TYPE_CHECKING:
    from matplotlib.axes import Axes

IMAGES = Path(__file__).parent / "images"

SPRINGS = ("component", "spring_damper", "quadrant", "quadrant_smoothed", "zero_torque")
OTHERS = ("infrared", "sector_sum", "impedance_urbano", "impedance_kondo")

TURNING = {
    "component": "#1864ab",
    "spring_damper": "#e8590c",
    "quadrant": "#c1121f",
    "quadrant_smoothed": "#6a0dad",
}
"""Laws whose torques are drawn over each other, and their colours."""

BEND: tuple[Segment, ...] = (
    ((-1.2, -0.5), (0.5, -0.5)),
    ((0.5, -0.5), (0.5, 1.2)),
    ((-1.2, 0.5), (-0.5, 0.5)),
    ((-0.5, 0.5), (-0.5, 1.2)),
)
"""A corridor of 1 m that turns left."""

CORNER: tuple[Segment, ...] = (((-1.2, 0.5), (0.5, 0.5)), ((0.5, -0.7), (0.5, 0.5)))
"""A wall on the left and one across."""


class Drive(NamedTuple):
    """Places that a robot passes between walls; `along` is what the picture's axis shows."""

    title: str
    walls: tuple[Segment, ...]
    poses: tuple[PlanarPose, ...]
    along: tuple[float, ...]
    axis: str


def drives() -> tuple[Drive, ...]:
    """Give two turns in the bend and a way into the corner, none of which touches a wall."""
    parts = np.linspace(0.0, 1.0, 91)
    headings = parts * pi / 2.0
    spot = tuple(PlanarPose(0.1, 0.0, float(heading)) for heading in headings)
    close = tuple(
        PlanarPose(0.10 + 0.08 * part, -0.22 + 0.12 * part, part * pi / 2.0)
        for part in parts.tolist()
    )
    gaps = np.linspace(0.48, 0.31, 86)
    into = tuple(PlanarPose(0.5 - gap, 0.25, 0.0) for gap in gaps.tolist())
    turned = tuple(degrees(heading) for heading in headings)
    return (
        Drive("turning on the spot in a bend", BEND, spot, turned, "heading in degrees"),
        Drive("turning close to its outer walls", BEND, close, turned, "heading in degrees"),
        Drive("into a corner", CORNER, into, tuple(gaps), "wall ahead in m, from the centre"),
    )


def torques(law: Law, drive: Drive) -> list[float]:
    """Give a law's torque in N·m at each place of a drive, standing still."""
    scans = (cast(drive.walls, pose, RAYS, MAX_RANGE) for pose in drive.poses)
    return [shown(law, scan).tau for scan in scans]


def draw_torques(path: Path) -> None:
    """Draw each drive's plan, and below it the torque of each law along it."""
    with picture(path, replace=True) as figure:
        figure.set_size_inches(9.0, 5.4)
        plans, panels = figure.subplots(2, 3, height_ratios=(1.0, 1.2))
        for plan, panel, drive in zip(plans, panels, drives(), strict=True):
            _draw_plan(plan, drive)
            _draw_torques(panel, drive)
        panels[0].set_ylabel("torque in N·m\ncounter-clockwise above zero")
        handles, names = panels[0].get_legend_handles_labels()
        figure.legend(handles, names, loc="outside lower center", ncols=4, frameon=False)


def _draw_plan(axes: Axes, drive: Drive) -> None:
    axes.set(xlim=(-0.9, 0.75), ylim=(-0.75, 0.9), aspect="equal")
    axes.set_title(drive.title, color=INK, fontsize=10.0)
    axes.set_axis_off()
    for wall in drive.walls:
        axes.plot(*zip(*wall, strict=True), color=INK, linewidth=3, solid_capstyle="butt", zorder=2)
    for pose in (drive.poses[0], drive.poses[len(drive.poses) // 2], drive.poses[-1]):
        draw_robot(axes, NoLaw(), pose)
    axes.plot([p.x for p in drive.poses], [p.y for p in drive.poses], color=INK, zorder=3)


def _draw_torques(axes: Axes, drive: Drive) -> None:
    axes.axhline(0.0, color="#9aa1ab", linewidth=0.8)
    for kind, colour in TURNING.items():
        law = load_kind("laws", kind)()
        axes.plot(drive.along, torques(law, drive), color=colour, linewidth=1.4, label=kind)
    axes.set_xlabel(drive.axis)
    axes.set_xlim(drive.along[0], drive.along[-1])
    if drive.along[-1] == 90.0:
        axes.set_xticks([0.0, 30.0, 60.0, 90.0])


def main(folder: Path) -> None:
    """Write all pictures into a folder, over what is there."""
    for name, kinds in {"law_springs": SPRINGS, "law_others": OTHERS}.items():
        laws = [load_kind("laws", kind)() for kind in kinds]
        draw_field(laws, folder / f"{name}.png", replace=True)
    draw_torques(folder / "law_torques.png")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if sys.argv[1:] else IMAGES)

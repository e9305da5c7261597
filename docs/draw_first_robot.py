"""Draw docs/first-robot.md's pictures and print its tables: `python docs/draw_first_robot.py`."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from first_robot import (
    CONDITIONS,
    DRAWN_GAP,
    FAULTLESS,
    NAMES,
    RATES_FROM_RANGES,
    Floats,
    corner_table,
    drive,
    driven_table,
    fields,
    force_of,
    forces,
    jumps,
    pass_corner,
    sensors_table,
)

from omnistudy.laws.boundary import Boundary, RectangularBoundary
from omnistudy.laws.springs import SpringLaw
from omnistudy.pictures import picture
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.plants.nexus import Nexus
from omnistudy.session.rehearsal import Rehearsed

if TYPE_CHECKING:
    from matplotlib.axes import Axes

IMAGES = Path(__file__).parent / "images"
CLEARANCE = 0.05
"""m from the robot's outline to the post, along the ray."""


def draw_corner(path: Path) -> None:
    """Draw what the sensors told and what the hand felt along the corner pass."""
    with picture(path, replace=True) as figure:
        figure.set_size_inches(8.0, 6.0)
        ranges, felt = figure.subplots(2, 1, sharex=True)
        x, scans = pass_corner(InfraredRing(), DRAWN_GAP)
        told = np.array([scan.ranges for scan in scans])
        for sensor, (name, colour) in enumerate((("left", "#d55e00"), ("front left", "#e69f00"))):
            ranges.plot(x, told[:, sensor], color=colour, label=f"sensor {sensor + 1}, {name}")
        ranges.set(ylabel="range told in m", ylim=(0, 0.9))
        for field in fields():
            if field.sensors == RATES_FROM_RANGES:
                continue
            x, scans = pass_corner(field.sensors, DRAWN_GAP)
            force = forces(field.law, scans)
            strength = np.hypot(*force.T) / jumps(x, force).beside
            line = "--" if field.sensors == FAULTLESS else "-"
            felt.plot(
                x,
                strength,
                line,
                color=field.colour,
                label=field.name,
                linewidth=1.2,
                zorder=3 if line == "--" else 2,
            )
        felt.set(
            xlabel="robot's centre, m beyond the corner",
            ylabel="force, 1 beside the wall",
            ylim=(0, 2.6),
        )
        for axes in (ranges, felt):
            axes.axvline(0.0, color="#aab0b8", linewidth=0.8)
        ranges.legend(fontsize=8, frameon=False)
        felt.legend(fontsize=8, frameon=False, loc="upper right")


def depth(boundary: Boundary, outline: Boundary, angles: Floats) -> Floats:
    """Give how deep a post reaches in that stands CLEARANCE off the outline, m."""
    return boundary.reach(angles) - outline.reach(angles) - CLEARANCE


def draw_boundaries(path: Path) -> None:
    """Draw both boundaries round the robot, and how hard a post presses into them all round."""
    nexus = Nexus()
    outline = RectangularBoundary(
        half_length=nexus.half_length, half_width=nexus.half_width, layer_x=0.0, layer_y=0.0
    )
    angles = np.linspace(-np.pi, np.pi, 721)
    with picture(path, replace=True) as figure:
        figure.set_size_inches(8.0, 3.6)
        plan, pressed = figure.subplots(1, 2)
        _closed_line(plan, outline, angles, "#343a40")
        plan.text(0.0, 0.0, "robot", ha="center", va="center", fontsize=9)
        for field in fields()[3:]:
            assert isinstance(field.law, SpringLaw)
            _closed_line(plan, field.law.boundary, angles, field.colour)
            pressed.plot(
                np.degrees(angles),
                depth(field.law.boundary, outline, angles),
                color=field.colour,
                label=field.name,
            )
        plan.set(aspect="equal", xlabel="x in m, ahead", ylabel="y in m, left")
        pressed.legend(fontsize=8, frameon=False, loc="lower center")
        pressed.set(xlabel="direction in degrees from ahead", ylabel="depth in m", ylim=(0, 0.22))
        pressed.set_title(f"a post {CLEARANCE:g} m off the outline", fontsize=9)
        pressed.set_xticks([-180, -90, 0, 90, 180])


def _closed_line(axes: Axes, boundary: Boundary, angles: Floats, colour: str) -> None:
    reach = boundary.reach(angles)
    axes.plot(reach * np.cos(angles), reach * np.sin(angles), color=colour)


def draw_driven(driven: dict[str, list[Rehearsed]], path: Path) -> None:
    """Draw how strong the force was through the first participant's trials."""
    with picture(path, replace=True) as figure:
        figure.set_size_inches(8.0, 5.0)
        panels = figure.subplots(len(CONDITIONS), 1, sharex=True)
        colours = [field.colour for field in fields() if field.name in NAMES.values()]
        for axes, name, colour in zip(panels, CONDITIONS, colours, strict=True):
            t, force = force_of(driven[name][0])
            axes.plot(t, np.hypot(*force.T), color=colour, linewidth=0.8)
            axes.set(ylabel="force in N")
            axes.set_title(f"{NAMES[name]} (virtual participant)", fontsize=9, loc="left")
        panels[-1].set_xlabel("s since the trial opened")


def main() -> None:
    """Do all of it."""
    print("\n".join(corner_table()), end="\n\n")
    draw_corner(IMAGES / "first_robot_corner.png")
    draw_boundaries(IMAGES / "first_robot_boundaries.png")
    driven = drive()
    print("\n".join(driven_table(driven)), end="\n\n")
    print("\n".join(sensors_table()))
    draw_driven(driven, IMAGES / "first_robot_driven.png")


if __name__ == "__main__":
    main()

"""What laws do on a grid of places beside walls, drawn."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from omnistudy.geometry import PlanarPose
from omnistudy.laws.law import Law
from omnistudy.laws.probe import Probe
from omnistudy.laws.robot_drawing import CLOCKWISE, COUNTER_CLOCKWISE, INK, ROBOT, draw_robot
from omnistudy.laws.shown import shown, stick_shown
from omnistudy.laws.standard_scenes import STANDARD_SCENES, VIEW, StandardScene
from omnistudy.pictures import picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import LinearSegmentedColormap, Normalize
    from matplotlib.figure import Figure
    from matplotlib.quiver import Quiver

GRID_STEP = 0.1
"""m between the places at which a law is asked."""

NEWTONS_PER_METRE_DRAWN = 60.0
"""An arrow of 1 m in the picture is this force."""

WHAT_IS_DRAWN = "what the hand feels where the robot stands"

TICKS = (-1.0, -0.1, 0.0, 0.1, 1.0)
"""Where the scale of torque is labelled among several laws, as parts of the largest."""

ALONE, ROW = (9.0, 5.4), (11.0, 1.45)
"""Inches of the picture of one law, and of the row of each of several."""


@dataclass(frozen=True, slots=True)
class Asked:
    """A place of the robot and what the law gives there, the stick held as the title says."""

    pose: PlanarPose
    found: Probe


def draw_field(laws: Sequence[Law], path: Path, replace: bool = False) -> None:
    """Draw force arrows, coloured by torque, for a robot that faces +x in four scenes.

    Several laws are drawn one below the other, on one scale. Raises UnknownPictureFormat,
    PictureExists or NoForce.
    """
    with picture(path, replace) as figure:
        answers = [[tuple(_ask(law, scene)) for scene in STANDARD_SCENES] for law in laws]
        largest = (
            max(abs(asked.found.tau) for law in answers for scene in law for asked in scene) or 1.0
        )
        several = len(laws) > 1
        shade = _shade(largest, several)
        panels = _panels(figure, laws)
        for law, row, scenes in zip(laws, panels, answers, strict=True):
            for axes, scene, asked in zip(row, STANDARD_SCENES, scenes, strict=True):
                arrows = _draw_scene(axes, law, scene, asked, shade)
        low = 0.03 * ALONE[1] / figure.get_figheight()
        axes.quiverkey(
            arrows, 0.84, low, 10.0, "10 N", labelpos="E", coordinates="figure", color=INK
        )
        ticks = [part * largest for part in TICKS] if several else None
        bar = figure.colorbar(
            arrows, ax=figure.axes, shrink=0.75, aspect=30, ticks=ticks, format="{x:.3g}"
        )
        bar.minorticks_off()
        bar.set_label("torque in N·m: purple turns counter-clockwise, red clockwise")


def _panels(figure: Figure, laws: Sequence[Law]) -> Sequence[Sequence[Axes]]:
    """Give the axes of each law's four scenes: a square for one law, a row for each of several."""
    if len(laws) == 1:
        figure.set_size_inches(*ALONE)
        title = f"law '{laws[0].kind}': {WHAT_IS_DRAWN}{stick_shown(laws[0])}"
        figure.suptitle(title, color=INK)
        panels = [figure.subplots(2, 2).ravel()]
    else:
        figure.set_size_inches(ROW[0], ROW[1] * len(laws) + 0.6)
        figure.suptitle(WHAT_IS_DRAWN, color=INK)
        panels = list(figure.subplots(len(laws), len(STANDARD_SCENES)))
        for row, law in zip(panels, laws, strict=True):
            _name_row(row[0], law)
    for axes, scene in zip(panels[0], STANDARD_SCENES, strict=True):
        axes.set_title(scene.title, color=INK, fontsize=10.0)
    return panels


def _name_row(first: Axes, law: Law) -> None:
    """Write a law's kind to the left of its first scene."""
    name = law.kind + stick_shown(law).replace(", ", "\n")
    first.annotate(
        name,
        (-0.05, 0.5),
        xycoords="axes fraction",
        rotation=90.0,
        ha="right",
        va="center",
        color=INK,
    )


def _shade(largest: float, several: bool) -> Normalize:
    """Give how a torque becomes a colour; among several laws small torques must show too."""
    from matplotlib.colors import AsinhNorm, Normalize

    if several:
        return AsinhNorm(largest / 50.0, vmin=-largest, vmax=largest)
    return Normalize(-largest, largest)


def _ask(law: Law, scene: StandardScene) -> Iterator[Asked]:
    """Ask the law wherever the robot fits."""
    for pose, scan in scene.scans(GRID_STEP):
        if ROBOT.penetrations(scan) is None:
            yield Asked(pose, shown(law, scan))


def _draw_scene(
    axes: Axes, law: Law, scene: StandardScene, asked: tuple[Asked, ...], shade: Normalize
) -> Quiver:
    left, low = scene.middle[0] - VIEW[0] / 2, scene.middle[1] - VIEW[1] / 2
    axes.set(xlim=(left, left + VIEW[0]), ylim=(low, low + VIEW[1]), aspect="equal")
    axes.set_axis_off()
    draw_robot(axes, law, PlanarPose(*scene.shown, 0.0))
    for wall in scene.walls:
        axes.plot(*zip(*wall, strict=True), color=INK, linewidth=4, solid_capstyle="butt", zorder=2)
    x = [at.pose.x for at in asked]
    y = [at.pose.y for at in asked]
    axes.plot(x, y, ".", color="#aab0b8", markersize=2.5, zorder=2)
    return axes.quiver(
        x,
        y,
        [at.found.fx for at in asked],
        [at.found.fy for at in asked],
        [at.found.tau for at in asked],
        cmap=_torque_colours(),
        norm=shade,
        angles="xy",
        scale_units="xy",
        scale=NEWTONS_PER_METRE_DRAWN,
        units="inches",
        width=0.025,
        zorder=3,
    )


def _torque_colours() -> LinearSegmentedColormap:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("torque", [CLOCKWISE, "#8a9099", COUNTER_CLOCKWISE])

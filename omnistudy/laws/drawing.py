"""What a law does on a grid of places beside walls, drawn."""

from __future__ import annotations

from collections.abc import Iterator
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
    from matplotlib.quiver import Quiver

GRID_STEP = 0.1
"""m between the places at which a law is asked."""

NEWTONS_PER_METRE_DRAWN = 60.0
"""An arrow of 1 m in the picture is this force."""


@dataclass(frozen=True, slots=True)
class Asked:
    """A place of the robot and what the law gives there, the stick held as the title says."""

    pose: PlanarPose
    found: Probe


def draw_field(law: Law, path: Path, replace: bool = False) -> None:
    """Draw force arrows, coloured by torque, for a robot that faces +x in four scenes.

    Raises UnknownPictureFormat, PictureExists or NoForce.
    """
    with picture(path, replace) as figure:
        from matplotlib.colors import Normalize

        answers = [tuple(_ask(law, scene)) for scene in STANDARD_SCENES]
        largest = max(abs(asked.found.tau) for scene in answers for asked in scene)
        shade = Normalize(-largest or -1.0, largest or 1.0)
        figure.set_size_inches(9.0, 5.4)
        panels = figure.subplots(2, 2).flat
        for axes, scene, asked in zip(panels, STANDARD_SCENES, answers, strict=True):
            arrows = _draw_scene(axes, law, scene, asked, shade)
        title = f"law '{law.kind}': what the hand feels where the robot stands{stick_shown(law)}"
        figure.suptitle(title, color=INK)
        axes.quiverkey(arrows, 0.84, 0.03, 10.0, "10 N", labelpos="E", color=INK)
        bar = figure.colorbar(arrows, ax=figure.axes, shrink=0.75, aspect=30)
        bar.set_label("torque in N·m: purple turns counter-clockwise, red clockwise")


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
    axes.set_title(scene.title, color=INK, fontsize=10.0)
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

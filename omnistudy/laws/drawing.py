"""What a law does on a grid of places beside walls, drawn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from omnistudy.geometry import ZERO_MATRIX, PlanarPose, PlanarTwist, PlanarWrench
from omnistudy.laws.boundary import Boundary, RectangularBoundary
from omnistudy.laws.law import Law, Sensed
from omnistudy.laws.picture import picture
from omnistudy.laws.standard_scenes import STANDARD_SCENES, StandardScene

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.colors import LinearSegmentedColormap, Normalize
    from matplotlib.quiver import Quiver

GRID_STEP = 0.1
"""m between the places at which a law is asked."""

NEWTONS_PER_METRE_DRAWN = 60.0
"""An arrow of 1 m in the picture is this force."""

CLOCKWISE = "#c1121f"
COUNTER_CLOCKWISE = "#6a0dad"
"""Red clockwise and purple counter-clockwise, as the thesis drew torque (appendix B)."""

_ROBOT = RectangularBoundary(layer_x=0.0, layer_y=0.0)


@dataclass(frozen=True, slots=True)
class Asked:
    """A place of the robot and what the law gives there, standing still."""

    pose: PlanarPose
    wrench: PlanarWrench


def draw_field(law: Law, path: Path, replace: bool = False) -> None:
    """Draw force arrows, coloured by torque, for a robot that faces +x in four scenes.

    Raises UnknownPictureFormat or PictureExists.
    """
    answers = [tuple(_ask(law, scene)) for scene in STANDARD_SCENES]
    largest = max((abs(asked.wrench.tau) for scene in answers for asked in scene), default=0.0)
    with picture(path, replace) as figure:
        from matplotlib.colors import Normalize

        figure.set_size_inches(8.0, 6.4)
        shade = Normalize(-largest, largest) if largest > 0.0 else Normalize(-1.0, 1.0)
        panels = figure.subplots(2, 2).flat
        for axes, scene, asked in zip(panels, STANDARD_SCENES, answers, strict=True):
            arrows = _draw_scene(axes, scene, asked, shade)
        figure.suptitle(f"law '{law.kind}': force and torque on the hand, robot facing right")
        axes.quiverkey(arrows, 0.0, -0.32, 10.0, "10 N", labelpos="E", color="0.3")
        figure.colorbar(
            arrows, ax=figure.axes, shrink=0.7, label="torque in N·m, counter-clockwise positive"
        )


def _ask(law: Law, scene: StandardScene) -> Iterator[Asked]:
    """Ask the law wherever the robot fits."""
    for pose, scan in scene.scans(GRID_STEP):
        if scan.ranges.min() > _ROBOT.half_width and _ROBOT.penetrations(scan) is None:
            sensed = Sensed(scan, PlanarTwist(0.0, 0.0, 0.0), ZERO_MATRIX)
            yield Asked(pose, law.field(sensed).wrench)


def _draw_scene(
    axes: Axes, scene: StandardScene, asked: tuple[Asked, ...], shade: Normalize
) -> Quiver:
    axes.set(title=scene.title, aspect="equal", xlabel="x in m", ylabel="y in m")
    for wall in scene.walls:
        axes.plot(*zip(*wall, strict=True), color="black", linewidth=3, solid_capstyle="butt")
    x = [at.pose.x for at in asked]
    y = [at.pose.y for at in asked]
    axes.plot(x, y, ".", color="0.8", markersize=2)
    arrows = axes.quiver(
        x,
        y,
        [at.wrench.fx for at in asked],
        [at.wrench.fy for at in asked],
        [at.wrench.tau for at in asked],
        cmap=_torque_colours(),
        norm=shade,
        angles="xy",
        scale_units="xy",
        scale=NEWTONS_PER_METRE_DRAWN,
        width=0.006,
    )
    outline(axes, _ROBOT, asked[0].pose, "0.6")
    return arrows


def outline(axes: Axes, boundary: Boundary, pose: PlanarPose, colour: str, line: str = "-") -> None:
    """Draw a boundary round a robot at a pose."""
    import numpy as np

    angles = np.linspace(-np.pi, np.pi, 721)
    reach = boundary.reach(angles)
    x = pose.x + reach * np.cos(angles + pose.theta)
    y = pose.y + reach * np.sin(angles + pose.theta)
    axes.plot(x, y, line, color=colour, linewidth=0.8)


def _torque_colours() -> LinearSegmentedColormap:
    from matplotlib.colors import LinearSegmentedColormap

    return LinearSegmentedColormap.from_list("torque", [CLOCKWISE, "#b8b8b8", COUNTER_CLOCKWISE])

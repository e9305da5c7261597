"""The figures of the thesis's chapter 5, drawn from a run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise
from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from numpy.typing import NDArray

from omnistudy.arm.configuration import ArmBody, Configuration
from omnistudy.arm.find import load_arm
from omnistudy.arm.run import ArmRun, ArmStep
from omnistudy.geometry import wrapped
from omnistudy.pictures import picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure, SubFigure

FigureName = Literal["18", "19", "21", "22", "23"]
FIGURES: tuple[FigureName, ...] = ("18", "19", "21", "22", "23")
"""Numbers of the thesis's figures that can be drawn."""

INK, WANTED = "#2b2f36", "#e07b00"
"""What was done, and what was wanted."""

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#2b2f36")
"""Of the joints in their order (Okabe and Ito 2008)."""

SNAPSHOTS = 5
"""Postures drawn in figure 18."""

PANEL = (5.0, 3.6)
"""Width and height of one figure, inches."""

Floats = NDArray[np.float64]


def write_figures(
    run: ArmRun, path: Path, figures: Sequence[FigureName] = FIGURES, *, replace: bool = False
) -> None:
    """Draw figures into one .svg or .png file, one below the other in two columns.

    Raises UnknownPictureFormat, PictureExists unless `replace`, PictureNotWritten, or UnknownArm.
    """
    columns = min(len(figures), 2)
    rows = -(-len(figures) // columns)
    with picture(path, replace) as figure:
        figure.set_size_inches(columns * PANEL[0], rows * PANEL[1])
        places = np.ravel(figure.subfigures(rows, columns, squeeze=False))
        for name, place in zip(figures, places, strict=False):
            _DRAWN[name](run, place)


def _figure_18(run: ArmRun, place: SubFigure | Figure) -> None:
    axes: Any = place.add_subplot(projection="3d")
    body = ArmBody(load_arm(run.arm))
    chosen = np.linspace(0, len(run.steps) - 1, SNAPSHOTS).astype(int)
    for number, index in enumerate(chosen):
        step = run.steps[index]
        points = _arm_points(Configuration(body, np.array(step.joints), step.chair))
        shade = 0.75 - 0.75 * number / (SNAPSHOTS - 1)
        axes.plot(*points.T, color=str(shade), linewidth=1.6, marker="o", markersize=2)
    _hand_lines(run, axes)
    axes.set_title("18  the arm along the hand's path")


def _figure_19(run: ArmRun, place: SubFigure | Figure) -> None:
    axes = place.add_subplot()
    table = np.degrees([step.joints for step in run.steps])
    for index, column in enumerate(table.T):
        colour = COLOURS[index % len(COLOURS)]
        axes.plot(_times(run), column, color=colour, linewidth=1.2, label=f"joint {index + 1}")
    axes.legend(fontsize=6, ncols=2, frameon=False)
    _finish(run, axes, "19  joint angles", "deg")


def _figure_21(run: ArmRun, place: SubFigure | Figure) -> None:
    axes: Any = place.add_subplot(projection="3d")
    _hand_lines(run, axes)
    axes.legend(fontsize=7, frameon=False)
    axes.set_title("21  the hand in space")


def _figure_22(run: ArmRun, place: SubFigure | Figure) -> None:
    axes = place.add_subplot()
    done = np.array([step.chair[:2] for step in run.steps])
    wanted = np.array([_wanted_chair(step)[:2] for step in run.steps])
    for index, name in enumerate("xy"):
        colour = COLOURS[index]
        axes.plot(_times(run), done[:, index], color=colour, label=name)
        if np.isfinite(wanted).any():
            label = f"{name} of its own route"
            axes.plot(_times(run), wanted[:, index], color=colour, linestyle=":", label=label)
    axes.legend(fontsize=7, frameon=False)
    _finish(run, axes, "22  position of the chair", "m")


def _figure_23(run: ArmRun, place: SubFigure | Figure) -> None:
    axes = place.add_subplot()
    heading = [degrees(step.chair.theta) for step in run.steps]
    off = [degrees(abs(wrapped(step.bearing - step.chair.theta))) for step in run.steps]
    wanted = [degrees(_wanted_chair(step)[2]) for step in run.steps]
    axes.plot(_times(run), heading, color=INK, label="heading")
    axes.plot(_times(run), off, color=COLOURS[0], label="angle to the hand's path")
    if np.isfinite(wanted).any():
        axes.plot(
            _times(run), wanted, color=WANTED, linestyle=":", label="heading of its own route"
        )
    axes.legend(fontsize=7, frameon=False)
    _finish(run, axes, "23  heading of the chair", "deg")


_DRAWN: dict[FigureName, Callable[[ArmRun, SubFigure | Figure], None]] = {
    "18": _figure_18,
    "19": _figure_19,
    "21": _figure_21,
    "22": _figure_22,
    "23": _figure_23,
}


def _arm_points(at: Configuration) -> Floats:
    """Give the places of axle, base and joints in ground axes, (n + 2, 3), m."""
    chair = at.body.profile.chair
    local = np.ones((at.body.count + 2, 4))
    local[0, :3] = (-chair.arm_x, -chair.arm_y, -chair.arm_z)
    local[1, :3] = 0.0
    local[2:, :3] = at.frames[:, :3, 3]
    points: Floats = (local @ at.base.T)[:, :3]
    return points


def _hand_lines(run: ArmRun, axes: Any) -> None:
    hand = np.array([step.hand for step in run.steps])
    wanted = np.array([step.wanted for step in run.steps])
    axes.plot(*wanted.T, color=WANTED, linewidth=2.4, label="path")
    axes.plot(*hand.T, color=INK, linewidth=1.0, label="hand")
    axes.set_xlabel("x in m")
    axes.set_ylabel("y in m")
    axes.set_zlabel("z in m")
    axes.set_box_aspect(None, zoom=0.8)
    axes.locator_params(nbins=4)


def _wanted_chair(step: ArmStep) -> tuple[float, float, float]:
    nowhere = (float("nan"),) * 3
    return nowhere if step.wanted_chair is None else step.wanted_chair


def _times(run: ArmRun) -> list[float]:
    return [step.t for step in run.steps]


def _finish(run: ArmRun, axes: Axes, title: str, unit: str) -> None:
    """Give an axes its title and units, and a line where a new motion begins."""
    for before, after in pairwise(run.steps):
        if before.motion != after.motion:
            axes.axvline(after.t, color="#dadbdc", linewidth=1.0, zorder=0)
    axes.set_title(title)
    axes.set_xlabel("time in s")
    axes.set_ylabel(unit)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)

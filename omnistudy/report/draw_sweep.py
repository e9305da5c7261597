"""A sweep's design points by collisions, time and work, with the front that none dominates."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from omnistudy.analysis.sweep import OUTCOMES, DesignPoint, Ranking
from omnistudy.pictures import picture

if TYPE_CHECKING:
    from matplotlib.axes import Axes

FRONT = "#0072b2"
TIED = "#e69f00"
OTHER = "#b4b6b9"
"""Colours that colour-blind readers can tell apart (Okabe and Ito, 2008)."""

BESIDE = ("duration_s", "work_against_j")
"""What stands over the collisions, one panel each."""

LABELLED = 15
"""Rows of a front that still can be read beside each other."""


def draw_front(ranking: Ranking, path: Path, *, replace: bool = False) -> None:
    """Draw means over the nuisance; raises UnknownPictureFormat, PictureExists."""
    with picture(path, replace) as figure:
        figure.set_size_inches(9.0, 4.2)
        panels = figure.subplots(1, len(BESIDE))
        for axes, column in zip(panels, BESIDE, strict=True):
            _draw_panel(ranking, axes, column)
        panels[0].legend(loc="best", frameon=False, fontsize=8)
        figure.suptitle(
            f"{len(ranking.points)} design points, means over {ranking.nuisance_points} nuisance "
            f"points and {ranking.participants} virtual participants",
            fontsize=9,
        )


def _draw_panel(ranking: Ranking, axes: Axes, column: str) -> None:
    groups = (
        ([point for point in ranking.points if not point.in_front], OTHER, "dominated"),
        ([point for point in ranking.points if point.in_front], FRONT, "front"),
    )
    for chosen, colour, label in groups:
        _scatter(axes, chosen, column, color=colour, s=24, label=label)
    by = f"{ranking.order.replace('_', ' ')} of {ranking.by}"
    tied = [point for point in ranking.points if point.tied]
    label = f"not told apart from the best ({by})"
    _scatter(axes, tied, column, facecolor="none", edgecolor=TIED, s=80, label=label)
    front = [point for point in ranking.points if point.in_front]
    for point in front[:LABELLED]:
        axes.annotate(
            str(point.row),
            (point.outcomes["collisions"], point.outcomes[column]),
            xytext=(4, 4),
            textcoords="offset points",
            fontsize=7,
        )
    axes.set_xlabel(OUTCOMES["collisions"])
    axes.set_ylabel(OUTCOMES[column])
    axes.spines[["top", "right"]].set_visible(False)


def _scatter(axes: Axes, points: Sequence[DesignPoint], column: str, **style: Any) -> None:
    if points:
        axes.scatter(
            [point.outcomes["collisions"] for point in points],
            [point.outcomes[column] for point in points],
            **style,
        )

"""A sweep's design points by collisions, time and work, with the front that none dominates."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from omnistudy.analysis.sweep import OUTCOMES, Ranking
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
    tied = f"not told apart from the best ({ranking.order.replace('_', ' ')} of {ranking.by})"
    for colour, label, chosen in (
        (OTHER, "others", [p for p in ranking.points if not p.tied and not p.in_front]),
        (TIED, tied, [p for p in ranking.points if p.tied and not p.in_front]),
        (FRONT, "front", [p for p in ranking.points if p.in_front]),
    ):
        if chosen:
            axes.scatter(
                [point.outcomes["collisions"] for point in chosen],
                [point.outcomes[column] for point in chosen],
                color=colour,
                edgecolor=[TIED if point.tied else colour for point in chosen],
                linewidth=1.5,
                s=28,
                label=label,
            )
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

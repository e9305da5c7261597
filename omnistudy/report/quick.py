"""One picture of a few trials: the driven ways on the plan, collisions as dots."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.report.picture import watermark
from omnistudy.report.style import colours, drawing, name_of
from omnistudy.session.rehearsal import Rehearsed
from omnistudy.worlds.drawing import draw_plan

T, X, Y = (SAMPLE_COLUMNS.index(name) for name in ("t", "x", "y"))


def draw_trials(driven: Sequence[Rehearsed], path: Path) -> None:
    """Write a PNG with one plan a trial; a picture that is there is replaced."""
    palette = colours(tuple(one.condition for one in driven))
    with drawing():
        figure = Figure(figsize=(6.0 * len(driven), 6.0), facecolor="white")
        watermark(figure, "virtual")
        for axes, one in zip(
            figure.subplots(1, len(driven), squeeze=False)[0], driven, strict=True
        ):
            draw_plan(one.world, axes, routes=False, labels=False)
            axes.set_axis_off()
            _draw_way(axes, one, palette[one.condition])
        figure.subplots_adjust(left=0.02, right=0.98, top=0.92, bottom=0.02, wspace=0.04)
        figure.savefig(path, format="png", dpi=120, metadata={"Software": None})


def _draw_way(axes: Axes, one: Rehearsed, colour: str) -> None:
    samples = one.result.samples
    starts = [event.t for event in one.result.events if event.kind == "collision"]
    axes.plot(samples[:, X], samples[:, Y], color=colour, lw=1.4, zorder=5)
    axes.plot(
        np.interp(starts, samples[:, T], samples[:, X]),
        np.interp(starts, samples[:, T], samples[:, Y]),
        "o",
        ms=4,
        color="black",
        zorder=6,
    )
    axes.set_title(
        f"{name_of(one.condition)}: {one.result.collisions} collisions "
        f"in {one.result.duration_s:.0f} s"
    )

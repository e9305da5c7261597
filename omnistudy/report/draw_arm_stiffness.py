"""The curve of collisions with feedback over the prior of arm stiffness."""

from __future__ import annotations

from math import isfinite

from matplotlib.figure import Figure

from omnistudy.analysis.arm_stiffness import ArmStiffnessCurve
from omnistudy.report.picture import DataTable, to_svg, watermark
from omnistudy.report.style import (
    INK,
    MUTED,
    PAPER,
    WITH_COLOUR,
    drawing,
    only_horizontal_lines,
)

PUBLISHED_MEAN = 5.0
"""Mean collisions with feedback (Tyagi 2017, sec. 5.1), drawn as a line to compare with."""


def draw_arm_stiffness(curve: ArmStiffnessCurve, key: str, alt: str, kind: str) -> str:
    """Give the SVG: mean over quantiles, a thin line a participant, the thesis's mean beside."""
    points = [point for point in curve.points if isfinite(point.collisions.mean)]
    quantiles = [point.quantile for point in points]
    means = [point.collisions.mean for point in points]
    with drawing():
        figure = Figure(figsize=(7.6, 3.3))
        axes = figure.add_axes((0.075, 0.17, 0.80, 0.72))
        watermark(figure, kind)
        for line in curve.lines:
            axes.plot(line.quantiles, line.means, color=WITH_COLOUR, alpha=0.25, lw=1.0, zorder=2)
        axes.plot(
            quantiles, means, color=WITH_COLOUR, lw=2.2, marker="o", ms=6, mec=PAPER, zorder=4
        )
        axes.axhline(PUBLISHED_MEAN, color=INK, lw=1.0, ls=(0, (4, 3)), zorder=3)
        axes.text(
            1.01,
            PUBLISHED_MEAN,
            " thesis: 5",
            va="center",
            color=INK,
            fontsize=8.5,
            transform=axes.get_yaxis_transform(),
        )
        for x, mean in zip(quantiles, means, strict=True):
            axes.annotate(
                f"{mean:.1f}",
                (x, mean),
                xytext=(0, 7),
                textcoords="offset points",
                ha="center",
                fontsize=8.5,
                fontweight="bold",
                color=INK,
                zorder=5,
            )
        axes.set_xlim(0.0, 1.0)
        tops = [value.value for point in points for value in point.values]
        axes.set_ylim(0.0, max(1.5 * PUBLISHED_MEAN, *tops) * 1.08 if tops else 10.0)
        axes.set_xticks(quantiles)
        axes.set_xlabel("quantile of the arm-stiffness prior: compliant arm to stiff arm")
        axes.set_title("collisions per trial with feedback", color=MUTED, fontsize=8.5)
        only_horizontal_lines(axes)
        axes.tick_params(axis="x", pad=8)
        return to_svg(figure, key, alt)


def arm_stiffness_tables(curve: ArmStiffnessCurve) -> tuple[DataTable, DataTable]:
    """Give the curve as a table to be read, and every trial as one to be downloaded."""
    shown = DataTable(
        ("quantile", "condition", "mean (count)", "SD (count)", "trials", "out of time"),
        tuple(
            (
                point.quantile,
                point.condition,
                point.collisions.mean,
                point.collisions.sd,
                point.collisions.n,
                point.timed_out,
            )
            for point in curve.points
        ),
    )
    data = DataTable(
        ("quantile", "condition", "repetition", "position", "participant", "collisions (count)"),
        tuple(
            (
                point.quantile,
                point.condition,
                value.repetition,
                value.position,
                value.participant,
                value.value,
            )
            for point in curve.points
            for value in point.values
        ),
    )
    return shown, data

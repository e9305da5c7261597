"""Bars of collisions or times with their spread, every trial a dot."""

from __future__ import annotations

from math import isfinite

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omnistudy.analysis.outcomes import Bar, Outcomes
from omnistudy.report.picture import DataTable, to_svg, watermark
from omnistudy.report.style import (
    INK,
    MUTED,
    PAPER,
    colours,
    drawing,
    name_of,
    only_horizontal_lines,
)


def draw_outcomes(outcomes: Outcomes, key: str, alt: str, kind: str, axis: str) -> str:
    """Give the SVG: one bar a place, whisker of one SD, dots for the trials behind it."""
    palette = colours(tuple(dict.fromkeys(bar.place.condition for bar in outcomes.bars)))
    with drawing():
        figure = Figure(figsize=(7.6, 3.5))
        axes = figure.add_axes((0.075, 0.19, 0.915, 0.70))
        watermark(figure, kind)
        for place, bar in enumerate(outcomes.bars):
            _bar(axes, place, bar, palette[bar.place.condition])
        _axes(axes, outcomes, axis)
        return to_svg(figure, key, alt)


def _bar(axes: Axes, place: int, bar: Bar, colour: str) -> None:
    mean, sd = bar.estimate.mean, bar.estimate.sd
    if not isfinite(mean):
        axes.text(place, 0.0, "no trial", color=MUTED, ha="center", va="bottom", fontsize=8)
        return
    solid = bar.place.average
    axes.bar(
        place, mean, width=0.62, color=colour, alpha=0.92 if solid else 0.42, linewidth=0, zorder=2
    )
    if isfinite(sd):
        axes.plot([place, place], [max(0.0, mean - sd), mean + sd], color=INK, lw=1.1, zorder=4)
    if not solid:
        _dots(axes, place, bar, colour)
    axes.annotate(
        f"{mean:.0f}" if mean >= 100 or bar.estimate.n == 1 else f"{mean:.1f}",
        (place, 0),
        xytext=(0, -4),
        textcoords="offset points",
        ha="center",
        va="top",
        fontsize=8.5,
        fontweight="bold",
        color=INK,
    )


def _dots(axes: Axes, place: int, bar: Bar, colour: str) -> None:
    """Spread the dots evenly over the bar's width, in participants' order: no chance in it."""
    count = len(bar.values)
    for index, value in enumerate(bar.values):
        offset = 0.0 if count == 1 else -0.24 + 0.48 * index / (count - 1)
        axes.plot(
            place + offset, value.value, "o", ms=4.0, mfc=colour, mec=PAPER, mew=0.6, zorder=3
        )


def _axes(axes: Axes, outcomes: Outcomes, axis: str) -> None:
    bars = outcomes.bars
    axes.set_xticks(range(len(bars)))
    axes.set_xticklabels([_tick(bar) for bar in bars], fontsize=8.5)
    axes.set_xlim(-0.6, len(bars) - 0.4)
    tops = [value.value for bar in bars for value in bar.values]
    tops += [bar.estimate.mean + bar.estimate.sd for bar in bars if isfinite(bar.estimate.sd)]
    axes.set_ylim(0.0, max(1.0, *tops) * 1.06 if tops else 1.0)
    axes.set_title(axis, color=MUTED, fontsize=8.5)
    only_horizontal_lines(axes)
    axes.locator_params(axis="y", integer=True)
    axes.tick_params(axis="x", pad=17)


def _tick(bar: Bar) -> str:
    label = bar.place.label
    if label == bar.place.condition:
        return name_of(label).replace(" ", "\n", 1)
    return label.replace(" ", "\n", 1)


def outcome_tables(outcomes: Outcomes) -> tuple[DataTable, DataTable]:
    """Give the bars as a table to be read, and every trial as one to be downloaded."""
    unit = "s" if outcomes.unit == "s" else "count"
    shown = DataTable(
        ("label", "condition", f"mean ({unit})", f"SD ({unit})", "trials", "each trial"),
        tuple(
            (
                bar.place.label,
                bar.place.condition,
                bar.estimate.mean,
                bar.estimate.sd,
                bar.estimate.n,
                ", ".join(f"{value.participant} {value.value:g}" for value in bar.values)
                if not bar.place.average
                else "",
            )
            for bar in outcomes.bars
        ),
    )
    data = DataTable(
        (
            "label",
            "condition",
            "repetition",
            "position",
            "participant",
            f"{outcomes.quantity} ({unit})",
        ),
        tuple(
            (
                bar.place.label,
                bar.place.condition,
                value.repetition,
                value.position,
                value.participant,
                value.value,
            )
            for bar in outcomes.bars
            if not bar.place.average
            for value in bar.values
        ),
    )
    return shown, data

"""Force and torque over time, a row a condition."""

from __future__ import annotations

from textwrap import wrap

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from omnistudy.analysis.wrench import WrenchTrace
from omnistudy.report.picture import DataTable, to_svg, watermark
from omnistudy.report.style import INK, LINE, MUTED, colours, drawing, name_of

COLUMNS = (("fx", "forward force Fx (N)"), ("fy", "lateral force Fy (N)"), ("tau", "torque (N·m)"))


def draw_wrenches(traces: tuple[WrenchTrace, ...], key: str, alt: str, kind: str) -> str:
    """Give the SVG: three columns with one scale each, so that rows can be compared."""
    palette = colours(tuple(trace.condition for trace in traces))
    limits = np.maximum(np.array([trace.largest() for trace in traces]).max(axis=0), 1e-3) * 1.05
    with drawing():
        height = 0.85 + 0.95 * len(traces)
        figure = Figure(figsize=(7.6, height))
        watermark(figure, kind)
        grid = figure.subplots(len(traces), 3, sharex="row", squeeze=False)
        figure.subplots_adjust(
            left=0.2,
            right=0.99,
            top=1 - 0.42 / height,
            bottom=0.52 / height,
            hspace=0.25,
            wspace=0.22,
        )
        for number, (row, trace) in enumerate(zip(grid, traces, strict=True)):
            seconds = broken_at_gaps(trace.t - trace.t[0]) if len(trace.t) else trace.t
            for axes, (name, title), limit in zip(row, COLUMNS, limits, strict=True):
                axes.axhline(0.0, color=LINE, lw=0.8, zorder=1)
                axes.plot(seconds, getattr(trace, name), color=palette[trace.condition], lw=0.9)
                axes.set_ylim(-limit, limit)
                axes.tick_params(labelsize=7.5, labelbottom=number == len(traces) - 1)
                axes.locator_params(axis="y", nbins=3)
                if number == 0:
                    axes.set_title(title, color=MUTED, fontsize=8.5)
            row[0].text(
                -0.3,
                0.5,
                "\n".join(wrap(name_of(trace.condition), 12)),
                color=INK,
                fontsize=8.5,
                transform=row[0].transAxes,
                ha="right",
                va="center",
            )
        grid[-1][1].set_xlabel("s since this part was entered", fontsize=8.5)
        return to_svg(figure, key, alt)


def broken_at_gaps(seconds: NDArray[np.float64]) -> NDArray[np.float64]:
    """Give NaN for the instants after which the part was left, so that no line joins the ends."""
    steps = np.diff(seconds, append=seconds[-1])
    return np.where(steps > 2.0 * np.median(steps), np.nan, seconds)


def wrench_tables(traces: tuple[WrenchTrace, ...]) -> tuple[DataTable, DataTable]:
    """Give a line a trace to be read, and every sample to be downloaded."""
    shown = DataTable(
        (
            "condition",
            "participant",
            "repetition",
            "part",
            "samples",
            "samples with any force (%)",
            "largest |Fx| (N)",
            "largest |Fy| (N)",
            "largest |torque| (N·m)",
        ),
        tuple(
            (
                trace.condition,
                trace.participant,
                trace.repetition,
                trace.part,
                len(trace.t),
                100.0 * trace.share_felt,
                *trace.largest(),
            )
            for trace in traces
        ),
    )
    data = DataTable(
        ("condition", "participant", "t (s)", "fx (N)", "fy (N)", "tau (N·m)"),
        tuple(
            (trace.condition, trace.participant, *(round(float(value), 4) for value in row))
            for trace in traces
            for row in zip(trace.t, trace.fx, trace.fy, trace.tau, strict=True)
        ),
    )
    return shown, data

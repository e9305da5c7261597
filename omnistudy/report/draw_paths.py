"""The plan with the driven ways, one small plan a condition."""

from __future__ import annotations

from math import ceil

from matplotlib.axes import Axes
from matplotlib.figure import Figure

from omnistudy.analysis.driven_paths import DrivenPath, DrivenPaths
from omnistudy.report.picture import DataTable, to_svg, watermark
from omnistudy.report.style import INK, MUTED, PAPER, colours, drawing, name_of
from omnistudy.worlds import World
from omnistudy.worlds.drawing import draw_plan, extent

ACROSS = 2
WIDTH = 7.6
SCALE_ROOM = 1.0
"""m below the plan, where its scale stands."""


def draw_paths(
    conditions: tuple[DrivenPaths, ...], world: World | None, key: str, alt: str, kind: str
) -> str:
    """Give the SVG: ways as thin lines, a dot wherever a collision began."""
    palette = colours(tuple(paths.condition for paths in conditions))
    rows = ceil(len(conditions) / ACROSS)
    left, right, bottom, top = _extent(conditions, world)
    cell = WIDTH / ACROSS * (top - bottom) / (right - left)
    with drawing():
        figure = Figure(figsize=(WIDTH, rows * (min(cell, 6.0) + 0.2)))
        watermark(figure, kind)
        grid = figure.subplots(rows, ACROSS, squeeze=False)
        figure.subplots_adjust(
            left=0.01, right=0.99, top=0.965, bottom=0.01, hspace=0.14, wspace=0.04
        )
        for axes in grid.flat:
            axes.set_axis_off()
        for axes, paths in zip(grid.flat, conditions, strict=False):
            if world is not None:
                draw_plan(world, axes, routes=False, labels=False)
            axes.set_axis_off()
            axes.set_aspect("equal")
            axes.set_xlim(left, right)
            axes.set_ylim(bottom, top)
            _paths(axes, paths, palette[paths.condition])
        return to_svg(figure, key, alt)


def _paths(axes: Axes, paths: DrivenPaths, colour: str) -> None:
    for path in paths.paths:
        axes.plot(path.x, path.y, color=colour, lw=0.7, alpha=0.55, zorder=5)
    for path in paths.paths:
        axes.plot(
            path.collision_x, path.collision_y, "o", ms=2.6, mfc=INK, mec=PAPER, mew=0.3, zorder=6
        )
    collisions = sum(len(path.collision_x) for path in paths.paths)
    axes.set_title(name_of(paths.condition), color=INK, fontsize=9)
    axes.set_title(
        f"{len(paths.paths)} trials, {collisions} collisions", color=MUTED, fontsize=8, loc="right"
    )


def _extent(
    conditions: tuple[DrivenPaths, ...], world: World | None
) -> tuple[float, float, float, float]:
    """Give left, right, bottom, top in m of all that is drawn, with a margin."""
    points = [
        (x, y)
        for paths in conditions
        for path in paths.paths
        for x, y in zip(path.x, path.y, strict=True)
    ]
    if world is not None:
        points += [(float(x), float(y)) for x, y in extent(world)]
    if not points:
        return -1.0, 1.0, -1.0, 1.0
    xs, ys = zip(*points, strict=True)
    return min(xs) - 0.2, max(xs) + 0.2, min(ys) - SCALE_ROOM, max(ys) + 0.2


def path_tables(conditions: tuple[DrivenPaths, ...]) -> tuple[DataTable, DataTable]:
    """Give a line a trial to be read, and every drawn point to be downloaded."""
    shown = DataTable(
        (
            "condition",
            "participant",
            "repetition",
            "route",
            "status",
            "way driven (m)",
            "collisions marked",
        ),
        tuple(
            (
                paths.condition,
                path.participant,
                path.repetition,
                path.route,
                path.status,
                path.length_m,
                len(path.collision_x),
            )
            for paths in conditions
            for path in paths.paths
        ),
    )
    data = DataTable(
        ("condition", "participant", "repetition", "what", "x (m)", "y (m)"),
        tuple(
            (paths.condition, path.participant, path.repetition, what, round(x, 2), round(y, 2))
            for paths in conditions
            for path in paths.paths
            for what, x, y in _points(path)
        ),
    )
    return shown, data


def _points(path: DrivenPath) -> list[tuple[str, float, float]]:
    return [
        *(("way", float(x), float(y)) for x, y in zip(path.x, path.y, strict=True)),
        *(
            ("collision", float(x), float(y))
            for x, y in zip(path.collision_x, path.collision_y, strict=True)
        ),
    ]

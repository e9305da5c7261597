"""The plan of a world: walls, blocks, door, regions, routes, start."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise
from math import ceil, floor, log10, pi
from typing import TYPE_CHECKING, Any

import numpy as np

from omnistudy.geometry import PlanarPose
from omnistudy.scene import Body, Box
from omnistudy.worlds.labels import label_place
from omnistudy.worlds.lanes import lanes
from omnistudy.worlds.obstacles import Points
from omnistudy.worlds.world import World

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.patches import Patch

INK = "#2b2f36"
WALL = "#4a505a"
ROUTES = ("#7a3e9d", "#e07b00", "#12807a", "#b0305c", "#4b6cb7", "#6b7a12")
"""Colours of the routes in their order."""

MOVING = "#c2410c"
"""Of bodies that move, and of their paths."""

TINTS = {"blue": "#d8e6fb", "green": "#d9f0de"}
"""Tint of the regions of a group; other groups are grey."""

FOOTPRINT = (0.58, 0.38)
"""Length and width in m of the robot drawn at the start."""

MARGIN = 0.4
"""Free space in m round what is drawn."""

LABEL_MARGIN = 1.4
"""The same at the sides where names of regions stand."""


def draw_plan(
    world: World,
    axes: Axes,
    *,
    routes: bool = True,
    labels: bool = True,
    footprint: tuple[float, float] = FOOTPRINT,
    grid: bool = False,
) -> None:
    """Draw a world seen from above, one unit a metre, with a scale and no frame.

    routes : False leaves the ways out, for driven paths to be drawn over the plan.
    labels : False leaves the names of regions out, where there is no room beside the plan.
    footprint : length and width in m of the robot at the start.
    grid : True draws lines of round coordinates in m, from which a way can be read.
    """
    _draw_regions(world, axes, labels)
    _draw_bodies(world.scene.bodies, axes)
    _draw_paths(world.scene.moving, axes)
    if routes and world.routes:
        _draw_routes(world, axes)
    _draw_start(world.start.pose, footprint, axes)
    low, high = extent(world)
    axes.set_aspect("equal")
    aside = LABEL_MARGIN if labels and world.regions else MARGIN
    axes.set_xlim(low[0] - aside, high[0] + aside)
    axes.set_ylim(low[1] - 2 * MARGIN, high[1] + MARGIN)
    axes.set_axis_off()
    if grid:
        _draw_grid(low, high, axes)
    _draw_scale(low, high, axes)


def extent(world: World) -> tuple[Points, Points]:
    """Give the lower left and the upper right corner (2,) in m of bodies, regions and routes."""
    outlines = [plan_outline(body) for body in world.scene.bodies]
    outlines += [np.array(region.polygon) for region in world.regions]
    outlines += [np.array(leg.path) for route in world.routes for leg in route.legs]
    outlines += [np.array(body.track.places) for body in world.scene.moving if body.track]
    corners = np.vstack((*outlines, (world.start.x, world.start.y)))
    return corners.min(axis=0), corners.max(axis=0)


def plan_outline(body: Body) -> Points:
    """Give the corners (n, 2) in m of a body seen from above."""
    if isinstance(body.geometry, Box):
        return _rectangle(PlanarPose(body.x, body.y, body.yaw), body.geometry.x, body.geometry.y)
    turn = np.linspace(0.0, 2 * pi, 24, endpoint=False)
    radius = body.geometry.radius
    return np.stack((body.x + radius * np.cos(turn), body.y + radius * np.sin(turn)), axis=1)


def _rectangle(pose: PlanarPose, length: float, width: float) -> Points:
    x, y = length / 2, width / 2
    return np.array([pose.to_world(*c) for c in ((x, y), (-x, y), (-x, -y), (x, -y))])


def _draw_regions(world: World, axes: Axes, labels: bool) -> None:
    for region in world.regions:
        tint = TINTS.get(region.group, "#ececea")
        axes.add_patch(_polygon(np.array(region.polygon), facecolor=tint, zorder=0))
        if not labels:
            continue
        place = label_place(region, world)
        group = f"{region.group} part" if region.group else ""
        axes.text(
            *place.at,
            "\n".join(filter(None, (region.name, group))),
            ha=place.horizontal,
            va=place.vertical,
            color=INK,
            fontsize=8,
            linespacing=1.1,
            zorder=6,
        )


def _draw_bodies(bodies: Sequence[Body], axes: Axes) -> None:
    from matplotlib.collections import PolyCollection

    walls = [plan_outline(body) for body in bodies if body.role == "wall" and not body.motion]
    axes.add_collection(
        PolyCollection(walls, facecolor=WALL, edgecolor=WALL, linewidth=0.3, zorder=3)
    )
    for body in bodies:
        if body.role in ("target", "finish"):
            _draw_block(body, axes)
        elif body.role == "door":
            _draw_door(body, axes)


def _draw_paths(bodies: Sequence[Body], axes: Axes) -> None:
    """Draw moving bodies where they are when a trial opens, and the paths of their centres."""
    for body in bodies:
        if (track := body.track) is None:
            continue
        path = np.array(track.places)
        axes.plot(*path.T, color=MOVING, linewidth=1.0, linestyle=(0, (1, 1.5)), zorder=4)
        axes.plot(*path.T, linestyle="none", marker="o", markersize=2.5, color=MOVING, zorder=4)
        x, y, _, _ = track.at(0.0)
        outline = plan_outline(body) + np.array((x - body.x, y - body.y))
        axes.add_patch(
            _polygon(outline, facecolor=MOVING, edgecolor="white", linewidth=0.8, zorder=5)
        )


def _draw_block(body: Body, axes: Axes) -> None:
    outline = plan_outline(body)
    axes.add_patch(
        _polygon(outline, facecolor=body.colour, edgecolor="white", linewidth=0.8, zorder=5)
    )


def _draw_door(body: Body, axes: Axes) -> None:
    """Draw the closed leaf, its hinge, and the ways it swings."""
    leaf = plan_outline(body)
    axes.add_patch(_polygon(leaf, facecolor=body.colour, edgecolor=INK, linewidth=0.4, zorder=4))
    if body.hinge is None:
        return
    closed = PlanarPose(body.x, body.y, body.yaw)
    hinge = closed.to_world(body.hinge.x, body.hinge.y)
    reach = max(float(np.hypot(*(corner - hinge))) for corner in leaf)
    far = closed.to_world(-body.hinge.x, -body.hinge.y)
    bearing = float(np.arctan2(far[1] - hinge[1], far[0] - hinge[0]))
    swing = np.linspace(bearing + body.hinge.lower, bearing + body.hinge.upper, 61)
    arc = np.stack((hinge[0] + reach * np.cos(swing), hinge[1] + reach * np.sin(swing)), axis=1)
    fan = np.vstack((hinge, arc, hinge))
    axes.plot(*fan.T, color=body.colour, linewidth=0.8, linestyle=(0, (3, 2)), zorder=2)
    axes.plot(*hinge, marker="o", markersize=3, color=INK, zorder=4)


def _draw_routes(world: World, axes: Axes) -> None:
    drawn = zip(world.routes, lanes(world), strict=True)
    for place, (route, line) in enumerate(drawn):
        colour = ROUTES[place % len(ROUTES)]
        axes.plot(
            *line.T,
            color=colour,
            linewidth=1.3,
            solid_joinstyle="round",
            label=f"{route.name}, {route.length:.1f} m",
            zorder=4,
        )
        for start, end in _long_segments(line):
            heading = float(np.degrees(np.arctan2(*(end - start)[::-1])))
            arrow = (3, 0, heading - 90.0)
            middle = (start + end) / 2
            axes.plot(*middle, marker=arrow, markersize=4.5, color=colour, zorder=4)
    axes.legend(
        loc="upper center",
        bbox_to_anchor=(0.5, 0.0),
        ncols=len(world.routes),
        frameon=False,
        fontsize=8,
        labelcolor=INK,
    )


def _long_segments(line: Points) -> list[tuple[Points, Points]]:
    return [(start, end) for start, end in pairwise(line) if np.hypot(*(end - start)) > 1.0]


def _draw_start(start: PlanarPose, footprint: tuple[float, float], axes: Axes) -> None:
    length, width = footprint
    axes.add_patch(
        _polygon(
            _rectangle(start, length, width),
            facecolor="#fffffff0",
            edgecolor=INK,
            linewidth=1.0,
            zorder=5,
        )
    )
    nose = [start.to_world(length * x, width * y) for x, y in ((0.4, 0), (0.1, 0.3), (0.1, -0.3))]
    axes.add_patch(_polygon(np.array(nose), facecolor=INK, zorder=5))


def _draw_scale(low: Points, high: Points, axes: Axes) -> None:
    """Draw a bar of a round length, about a fifth of the plan's width."""
    length = _round_length(float(high[0] - low[0]) / 5)
    x, y = float(low[0]), float(low[1]) - MARGIN
    axes.plot([x, x + length], [y, y], color=INK, linewidth=2, solid_capstyle="butt", zorder=5)
    axes.text(
        x + length / 2, y - 0.05, f"{length:g} m", ha="center", va="top", fontsize=8, color=INK
    )


def _draw_grid(low: Points, high: Points, axes: Axes) -> None:
    step = max(_round_length(float(max(high - low)) / 8), 0.1)
    ranges = [
        np.arange(ceil(a / step), b / step + 1e-9) * step for a, b in zip(low, high, strict=True)
    ]
    style: dict[str, Any] = {"color": INK, "alpha": 0.25, "linewidth": 0.5, "zorder": 2}
    for x in ranges[0]:
        axes.plot((x, x), (low[1], high[1]), **style)
        axes.text(x, high[1] + 0.05, f"{x:g}", ha="center", va="bottom", fontsize=7, color=INK)
    for y in ranges[1]:
        axes.plot((low[0], high[0]), (y, y), **style)
        axes.text(low[0] - 0.05, y, f"{y:g}", ha="right", va="center", fontsize=7, color=INK)


def _round_length(length: float) -> float:
    decade = 10.0 ** floor(log10(length))
    return float(max(step * decade for step in (1, 2, 5) if step * decade <= length))


def _polygon(corners: Points, **style: Any) -> Patch:
    from matplotlib.patches import Polygon

    return Polygon(corners, closed=True, **style)

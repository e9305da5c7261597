"""The robot, the boundary round it and walls, as every picture of a law shows them."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from omnistudy.geometry import PlanarPose
from omnistudy.laws.boundary import Boundary, RectangularBoundary, boundary_of
from omnistudy.laws.law import Law

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INK = "#2b2f36"
CLOCKWISE = "#c1121f"
COUNTER_CLOCKWISE = "#6a0dad"
"""Red clockwise and purple counter-clockwise, as the thesis drew torque (appendix B)."""

ROBOT = RectangularBoundary(layer_x=0.0, layer_y=0.0)
"""The robot's own outline."""


def draw_robot(axes: Axes, law: Law, pose: PlanarPose) -> None:
    """Draw the robot with a nose, and the law's boundary dashed round it where it has one."""
    from matplotlib.patches import Polygon

    half_length, half_width = ROBOT.half_length, ROBOT.half_width
    sides = ((1, 1), (-1, 1), (-1, -1), (1, -1))
    corners = [pose.to_world(half_length * x, half_width * y) for x, y in sides]
    axes.add_patch(Polygon(corners, facecolor="#e9ebee", edgecolor="#9aa1ab", zorder=1))
    tips = ((0.92, 0.0), (0.7, 0.35), (0.7, -0.35))
    nose = [pose.to_world(half_length * x, half_width * y) for x, y in tips]
    axes.add_patch(Polygon(nose, facecolor="#9aa1ab", zorder=1))
    boundary = boundary_of(law)
    if boundary is not None:
        _draw_boundary(axes, boundary, pose)


def _draw_boundary(axes: Axes, boundary: Boundary, pose: PlanarPose) -> None:
    angles = np.linspace(-np.pi, np.pi, 721)
    reach = boundary.reach(angles)
    x = pose.x + reach * np.cos(angles + pose.theta)
    y = pose.y + reach * np.sin(angles + pose.theta)
    axes.plot(x, y, color="#9aa1ab", linewidth=0.9, linestyle=(0, (4, 2)), zorder=1)

"""What hypothesis draws for the tests of laws: any scene, any movement."""

from __future__ import annotations

from math import cos, pi, sin

import numpy as np
from hypothesis import strategies as st

from omnistudy.geometry import PlanarTwist, Scan

MAX_RANGE = 0.6
RADIUS = 0.5
CLEAR = 1e-6
"""m from a boundary within which no obstacle is put: rounding would put it in or out."""

angles = st.floats(-pi, pi, allow_subnormal=False)
twists = st.builds(
    PlanarTwist, st.floats(-0.36, 0.36), st.floats(-0.36, 0.36), st.floats(-1.2, 1.2)
)
sticks = st.tuples(st.floats(-0.04, 0.04), st.floats(-0.04, 0.04), st.floats(-1.0, 1.0))
gradients = st.tuples(*[st.tuples(*[st.floats(-20.0, 20.0)] * 3)] * 3)


@st.composite
def scans(draw: st.DrawFn) -> Scan:
    """Any scene: rays at any angles, some of which meet something."""
    rays = [
        (angle, distance)
        for angle, distance in draw(st.lists(st.tuples(angles, st.floats(0.05, 0.7)), max_size=12))
        if abs(distance - reach(angle)) > CLEAR and abs(distance - RADIUS) > CLEAR
    ]
    return Scan(
        np.array([angle for angle, _ in rays]),
        np.array([min(distance, MAX_RANGE) for _, distance in rays]),
        MAX_RANGE,
    )


@st.composite
def scans_from_around(draw: st.DrawFn) -> Scan:
    """Any scene, seen by sensors round the robot that tell how fast their ranges grow."""
    near, rate = st.floats(-0.35, 0.35), st.floats(-0.5, 0.5)
    rays = np.array(
        draw(st.lists(st.tuples(angles, st.floats(0.02, 0.7), near, near, rate), max_size=8)),
    ).reshape(-1, 5)
    return Scan(rays[:, 0], rays[:, 1], MAX_RANGE, rays[:, 2:4], rays[:, 4])


def reach(angle: float) -> float:
    """Give how far the published rectangle lies from the centre, in m."""
    ahead = 0.44 / abs(cos(angle))
    return min(ahead, 0.31 / abs(sin(angle))) if sin(angle) else ahead

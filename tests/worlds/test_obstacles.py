"""Distances to what stands in a world, measured in pieces and among the near alone."""

from __future__ import annotations

from math import inf, pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.scene import Body, Box, Cylinder
from omnistudy.worlds import obstacles as room
from omnistudy.worlds.obstacles import obstacles

coordinate = st.floats(-5.0, 5.0)


@st.composite
def bodies(draw: st.DrawFn) -> Body:
    size = st.floats(0.05, 2.0)
    shape: Box | Cylinder = Cylinder(radius=draw(size), length=1.0)
    if draw(st.booleans()):
        shape = Box(x=draw(size), y=draw(size), z=1.0)
    return Body(
        name="b",
        role="wall",
        geometry=shape,
        x=draw(coordinate),
        y=draw(coordinate),
        z=0.5,
        yaw=draw(st.floats(-pi, pi)),
    )


@given(
    st.lists(bodies(), max_size=6),
    st.lists(st.tuples(coordinate, coordinate), min_size=1, max_size=6),
    st.floats(0.0, 1.0),
)
def test_no_near_body_is_forgotten(
    given_bodies: list[Body], places: list[tuple[float, float]], radius: float
) -> None:
    points = np.array(places)
    everything = obstacles(given_bodies).distances(points).min(axis=1, initial=inf)
    near = obstacles(given_bodies).near(points, radius).distances(points).min(axis=1, initial=inf)
    within = everything <= radius
    assert (near[within] == everything[within]).all()


def test_far_bodies_are_not_measured() -> None:
    beside = [Body(name=f"b{x}", role="wall", geometry=Box(x=0.2, y=0.2, z=1), x=x, y=0, z=0.5)
              for x in range(5)]  # fmt: skip
    near = obstacles(beside).near(np.array([[1.0, 0.5], [2.0, 0.5]]), 0.5)
    assert near.names == ("b1", "b2")


def test_measuring_in_pieces_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    beside = obstacles(
        Body(name=f"b{x}", role="wall", geometry=Box(x=0.2, y=0.2, z=1), x=x, y=0, z=0.5)
        for x in range(5)
    )
    points = np.linspace((0.0, 1.0), (4.0, 1.0), 33)
    whole = beside.distances(points)
    monkeypatch.setattr(room, "PAIRS_AT_ONCE", 20)
    assert len(beside.pieces(points)) == 9
    assert (beside.distances(points) == whole).all()

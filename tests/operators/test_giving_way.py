"""A driver lets a moving body pass if going on would meet it and standing would not."""

from __future__ import annotations

import pytest

from omnistudy.geometry import PlanarPose
from omnistudy.operators.giving_way import waits
from omnistudy.operators.way import Way
from omnistudy.worlds import Leg, Passing

HERE = PlanarPose(0.0, 0.0, 0.0)
AHEAD = Leg(target="t", path=((0.0, 0.0), (10.0, 0.0)))


def lets_pass(*bodies: Passing, pose: PlanarPose = HERE) -> bool:
    way = Way(AHEAD)
    way.find(pose.x, pose.y)
    return waits(bodies, way, pose, speed=0.4, foresight=2.5, berth=0.15)


# In 2.5 s the driver gets 1 m ahead; robot and body touch at 0.35 + 0.25 m between their middles.
@pytest.mark.parametrize(
    ("body", "waiting"),
    [
        pytest.param(Passing(1.5, 0.0, 0.0, 0.0, 0.25), True, id="stands on the way"),
        pytest.param(Passing(1.8, 0.0, 0.0, 0.0, 0.25), False, id="stands far ahead"),
        pytest.param(Passing(1.5, 1.2, 0.0, -0.4, 0.25), True, id="comes from the left"),
        pytest.param(Passing(1.5, -1.2, 0.0, 0.4, 0.25), True, id="comes from the right"),
        pytest.param(Passing(1.5, 1.2, 0.0, 0.4, 0.25), False, id="goes away"),
        pytest.param(Passing(1.5, 2.2, 0.0, -0.4, 0.25), False, id="comes too late to matter"),
        pytest.param(Passing(1.0, 0.8, 0.4, 0.0, 0.25), False, id="goes beside the way"),
        pytest.param(Passing(-0.9, 0.0, 0.3, 0.0, 0.25), False, id="follows more slowly"),
        pytest.param(Passing(0.0, 1.4, 0.0, -0.4, 0.25), False, id="comes to where he is"),
        pytest.param(Passing(1.5, 0.0, -0.4, 0.0, 0.25), False, id="comes head-on"),
    ],
)
def test_one_body(body: Passing, waiting: bool) -> None:
    assert lets_pass(body) is waiting


def test_nobody_is_let_pass_where_nobody_moves() -> None:
    assert lets_pass() is False


def test_one_body_ahead_is_enough() -> None:
    away = Passing(5.0, 5.0, 0.0, 0.0, 0.25)
    assert lets_pass(away, Passing(1.5, 0.0, 0.0, 0.0, 0.25)) is True

"""Wheel speeds of the mecanum base, by hand and back."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.geometry import PlanarTwist
from omnistudy.plants.youbot import Youbot


@pytest.mark.parametrize(
    ("twist", "wheels"),
    [
        # front left, front right, rear left, rear right; 1/R = 20, l/R = 5.8
        (PlanarTwist(0.3, 0, 0), (6, 6, 6, 6)),
        (PlanarTwist(0, 0.2, 0), (-4, 4, 4, -4)),
        (PlanarTwist(0, 0, 1), (-5.8, 5.8, -5.8, 5.8)),
        (PlanarTwist(0.1, -0.05, 0.5), (0.1, 3.9, -1.9, 5.9)),
    ],
)
def test_rows_of_the_inverse_jacobian(twist: PlanarTwist, wheels: tuple[float, ...]) -> None:
    assert Youbot().wheel_speeds(twist) == pytest.approx(wheels)


speeds = st.floats(-2.0, 2.0)


@given(st.builds(PlanarTwist, speeds, speeds, speeds), st.floats(0.1, 0.6))
def test_wheels_give_the_twist_back(twist: PlanarTwist, lever: float) -> None:
    youbot = Youbot(wheel_lever=lever)
    assert youbot.twist(youbot.wheel_speeds(twist)) == pytest.approx(twist, abs=1e-12)


@given(st.tuples(speeds, speeds, speeds, speeds))
def test_wheels_that_fight_move_nothing(wheels: tuple[float, float, float, float]) -> None:
    fight = (1.0, 1.0, -1.0, -1.0)  # front against rear: no twist asks for that
    fought = tuple(w + f for w, f in zip(wheels, fight, strict=True))
    youbot = Youbot()
    assert youbot.twist(fought) == pytest.approx(youbot.twist(wheels), abs=1e-12)


def test_size() -> None:
    assert Youbot().width == pytest.approx(0.38)
    assert Youbot().circumradius == pytest.approx(0.34670, abs=1e-5)

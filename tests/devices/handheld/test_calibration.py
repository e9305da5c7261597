"""From what a device told at rest and at its ends to its page."""

from __future__ import annotations

import numpy as np
import pytest

from omnistudy.devices.handheld.axes import AxisMap, HardwareAxis
from omnistudy.devices.handheld.calibration import (
    AxisFound,
    Recorded,
    calibrated,
    found_in,
    steps_of,
)
from omnistudy.devices.handheld.sdl_stick import SdlStick
from omnistudy.errors.handheld import DidNotMove, Unsteady

LEVERS = tuple(HardwareAxis(f"axis_{n}", -100.0, 0.0, 100.0) for n in range(4))
BUTTONS = AxisMap(axis="axis_2", opposite="axis_3")
STICK = SdlStick(theta=BUTTONS)


def told(*rows: tuple[float, ...]) -> np.ndarray:
    return np.array(rows, dtype=np.float64)


def session(rest: np.ndarray, *ends: np.ndarray) -> tuple[Recorded, ...]:
    return tuple(Recorded(*both) for both in zip(steps_of(STICK), (rest, *ends), strict=True))


# axis_1 is forward and back, and falls when pushed forward; axis_0 is left and right.
REST = told((3, 5, 0, 0), (3, 6, 0, 0), (3, 4, 0, 0))
FORWARD, BACK = told((3, -75, 0, 0)), told((3, 85, 0, 0))
LEFT, RIGHT = told((-97, 5, 0, 0)), told((53, 5, 0, 0))


def test_it_leads_to_rest_and_both_ends_of_each_axis() -> None:
    assert [step.instruction for step in steps_of(STICK)] == [
        "let go of it",
        "hold it all the way forward",
        "hold it all the way back",
        "hold it all the way left",
        "hold it all the way right",
    ]
    pairs = STICK.model_copy(update={"x": BUTTONS, "y": BUTTONS})
    assert steps_of(pairs) == ()


def test_range_sign_and_noise_are_found() -> None:
    x, y = found_in(STICK, LEVERS, session(REST, FORWARD, BACK, LEFT, RIGHT))
    # ends at 98 % of the way, so that full is reached; stray 1 of 80, three of it below 5 %
    assert x == AxisFound("x", "axis_1", -73.4, 5.0, 83.4, -1, 1 / 80, 0.05)
    assert y == AxisFound("y", "axis_0", -95.0, 3.0, 52.0, -1, 0.0, 0.05)


def test_the_calibrated_device_reaches_its_ends_and_rests_in_between() -> None:
    found = found_in(STICK, LEVERS, session(REST, FORWARD, BACK, LEFT, RIGHT))
    device = calibrated(STICK, found, "today")
    x = device.x.on(LEVERS)
    assert [x.deflection(raw[0]) for raw in (FORWARD, BACK, REST)] == [1.0, -1.0, 0.0]
    assert device.theta == BUTTONS
    assert device.calibrated == "today"


def test_a_stick_that_runs_the_other_way_is_turned_round() -> None:
    x, _ = found_in(STICK, LEVERS, session(REST, BACK, FORWARD, LEFT, RIGHT))
    assert x.sign == 1


def test_a_noisy_stick_gets_a_wider_dead_zone() -> None:
    rest = told((3, 5, 0, 0), (3, 5 + 4, 0, 0), (3, 5, 0, 0))
    x, _ = found_in(STICK, LEVERS, session(rest, FORWARD, BACK, LEFT, RIGHT))
    assert x.dead_zone == pytest.approx(3 * 4 / 80)


def test_an_axis_that_stays_names_the_one_that_moved() -> None:
    other = told((3, 5, 80, 0))
    with pytest.raises(DidNotMove, match=r"'axis_1' .* forward; 'axis_2' moved: name it"):
        found_in(STICK, LEVERS, session(REST, other, other, LEFT, RIGHT))
    with pytest.raises(DidNotMove, match="hold it there until"):
        found_in(STICK, LEVERS, session(REST, REST, BACK, LEFT, RIGHT))
    with pytest.raises(DidNotMove, match="to two different ends"):
        found_in(STICK, LEVERS, session(REST, BACK, BACK, LEFT, RIGHT))


def test_a_hand_that_does_not_let_go_is_noticed() -> None:
    held = told((3, 5, 0, 0), (3, 40, 0, 0), (3, 5, 0, 0))
    with pytest.raises(Unsteady, match="'axis_1' strayed by 44%"):
        found_in(STICK, LEVERS, session(held, FORWARD, BACK, LEFT, RIGHT))

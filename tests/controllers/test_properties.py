"""What every controller of a robot on the floor keeps: a mirrored world, a turned one, rest."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.controllers import Control, Controller
from omnistudy.controllers.led import LedController
from omnistudy.controllers.resolved_rate import ResolvedRateController
from omnistudy.devices import DeviceState
from omnistudy.geometry import Scan
from omnistudy.registry import kinds, load_kind

OF_ARMS = {
    kind
    for kind in kinds("controllers")
    if issubclass(load_kind("controllers", kind), (ResolvedRateController, LedController))
}
KINDS = sorted({*kinds("controllers")} - OF_ARMS)
ANGLES = np.arange(-64, 64) * (np.pi / 64)
FAR = 0.6
DT = 1 / 240

axis = st.floats(-0.05, 0.05)
sticks = st.tuples(axis, axis, st.floats(-1.2, 1.2))
ranges = st.lists(st.floats(0.25, FAR), min_size=128, max_size=128).map(np.array)

Vector = tuple[float, ...]


def decided(kind: str, stick: Vector, scan: Scan | None, steps: int = 3) -> Control:
    """Hold the stick still for some steps; give the last decision."""
    controller: Controller = load_kind("controllers", kind)()
    device = DeviceState(stick, (0.0, 0.0, 0.0))
    state = controller.initial_state()
    for _ in range(steps):
        control = controller.control(device, None, scan, state, DT)
        state = control.state
    return control


def mirrored(values: Vector) -> Vector:
    x, y, theta = values
    return x, -y, -theta


def turned(values: Vector) -> Vector:
    x, y, theta = values
    return -x, -y, theta


@pytest.mark.parametrize("kind", KINDS)
@given(sticks, ranges)
def test_a_mirrored_scene_is_driven_mirrored(kind: str, stick: Vector, seen: np.ndarray) -> None:
    scan = Scan(ANGLES, seen, FAR)
    here, there = decided(kind, stick, scan), decided(kind, mirrored(stick), scan.mirrored())
    assert there.intent == pytest.approx(mirrored(here.intent), abs=1e-12)
    assert there.command == pytest.approx(mirrored(here.command), abs=1e-12)


@pytest.mark.parametrize("kind", KINDS)
@given(sticks)
def test_where_nothing_is_near_front_and_back_are_alike(kind: str, stick: Vector) -> None:
    free = Scan(ANGLES, np.full(ANGLES.shape, FAR), FAR)
    here, there = decided(kind, stick, free), decided(kind, turned(stick), free)
    assert there.intent == pytest.approx(turned(here.intent), abs=1e-12)
    assert there.command == pytest.approx(turned(here.command), abs=1e-12)


@pytest.mark.parametrize("kind", KINDS)
@given(ranges)
def test_a_stick_at_rest_is_no_command_whatever_is_near(kind: str, seen: np.ndarray) -> None:
    for scan in (Scan(ANGLES, seen, FAR), None):
        control = decided(kind, (0.0, 0.0, 0.0), scan)
        assert tuple(control.intent) == (0.0, 0.0, 0.0)
        assert tuple(control.command) == (0.0, 0.0, 0.0)


@pytest.mark.parametrize("kind", KINDS)
@given(sticks)
def test_before_the_first_scan_a_robot_drives_as_where_nothing_is_near(
    kind: str, stick: Vector
) -> None:
    free = Scan(ANGLES, np.full(ANGLES.shape, FAR), FAR)
    assert decided(kind, stick, None).command == decided(kind, stick, free).command

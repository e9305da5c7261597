"""What docs/first-robot.md says of six rays, a circle and a rectangle is what comes out."""

from __future__ import annotations

import importlib.util
import sys
from functools import cache
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest

from omnistudy.laws.boundary import CircularBoundary, RectangularBoundary
from omnistudy.laws.spring_damper import SpringDamperLaw
from omnistudy.plants.nexus import Nexus
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session.rehearsal import rehearse

DOCS = Path(__file__).resolve().parents[2] / "docs"


@cache
def numbers() -> ModuleType:
    """The script behind the page's numbers."""
    specification = importlib.util.spec_from_file_location("first_robot", DOCS / "first_robot.py")
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules["first_robot"] = module
    specification.loader.exec_module(module)
    return module


def test_jumps_are_counted_from_scan_to_scan() -> None:
    # 5 N beside the wall (a 3-4-5 triangle); then 0.3 N more, 4 N less in one scan, nothing
    x = np.array([-0.7, -0.6, -0.55, -0.2, 0.0, 0.1])
    force = np.array([[3.0, 4.0], [3.0, 4.0], [3.0, 4.0], [3.0, 4.3], [3.0, 0.3], [0.0, 0.0]])
    found = numbers().jumps(x, force)
    assert found.beside == 5.0
    assert found.greatest == pytest.approx(np.hypot(3.0, 4.3))
    assert found.largest == 4.0
    assert found.share == 0.8
    assert found.big == 2  # more than 0.5 N: the 4 N, and the last hypot(3, 0.3) N


def test_power_is_split_where_nobody_steers() -> None:
    # a slow wave of amplitude 2 (mean square 2) and a fast one of amplitude 1 (mean square 0.5)
    t = np.arange(800) / 80
    waves = np.stack([2 * np.sin(2 * np.pi * t) + 7.0, np.sin(2 * np.pi * 10 * t)], axis=1)
    assert numbers()._power(waves, 80.0) == pytest.approx((2.5, 0.5))


@pytest.mark.parametrize("gap", [0.04, 0.06, 0.10])
def test_at_a_corner_six_rays_jump_and_128_do_not(gap: float) -> None:
    six, circular, rectangular = (
        next(field for field in numbers().fields() if field.name == name)
        for name in ("six rays, faultless", "128 rays, circular", "128 rays, rectangular")
    )
    assert numbers().look(six, gap).share > 0.6
    assert numbers().look(circular, gap).share < 0.1
    assert numbers().look(rectangular, gap).share < 0.5


def test_the_oblique_ray_loses_the_wall_where_geometry_says() -> None:
    # from (0.2, 0.1) at 45 degrees to a wall 0.24 m aside: 0.2 + 0.14 m ahead of the centre
    x, scans = numbers().pass_corner(numbers().FAULTLESS, 0.06)
    told = np.array([scan.ranges for scan in scans])
    lost = [x[np.flatnonzero(told[:, sensor] > 0.79)[0]] for sensor in (1, 0)]
    assert lost == pytest.approx([-0.34, 0.0], abs=3e-3)


@pytest.mark.slow
def test_numbers_of_the_corner_are_on_the_page() -> None:
    page = (DOCS / "first-robot.md").read_text(encoding="utf-8")
    missing = [row for row in numbers().corner_table() if row not in page]
    assert missing == [], "stale: run `python docs/draw_first_robot.py` and take its table"


@pytest.mark.slow
def test_in_driven_trials_the_force_of_six_rays_is_the_least_steady() -> None:
    found = {
        driven.condition: numbers().steadiness(driven, 80.0)
        for driven in rehearse(compose_protocol("utah2017_sensors"), numbers().CONDITIONS)
    }
    assert found["six_rays"].unsteady > 1.5 * found["circular"].unsteady
    assert found["six_rays"].unsteady > 1.5 * found["rectangular"].unsteady
    assert found["circular"].felt > found["rectangular"].felt > found["six_rays"].felt


def test_boundaries_of_the_protocol_fit_the_robot() -> None:
    protocol = compose_protocol("utah2017_sensors")
    laws = {condition.name: condition.law for condition in protocol.conditions}
    circular, rectangular = laws["circular"], laws["rectangular"]
    assert isinstance(circular, SpringDamperLaw)
    assert isinstance(rectangular, SpringDamperLaw)
    assert laws["six_rays"] is None
    assert circular.stiffness == rectangular.stiffness
    nexus = Nexus()
    assert rectangular.boundary == RectangularBoundary(
        half_length=nexus.half_length, half_width=nexus.half_width
    )
    assert isinstance(circular.boundary, CircularBoundary)
    assert circular.boundary.radius == pytest.approx(nexus.circumradius + 0.15, abs=1e-3)


def test_the_protocol_sees_every_change_of_force() -> None:
    recording = compose_protocol("utah2017_sensors").recording
    assert recording.sample_hz > recording.scan_hz

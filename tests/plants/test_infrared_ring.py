"""The infrared sensors see walls where they are, with the noise and interference asked for."""

from __future__ import annotations

from math import cos, exp, pi, sqrt

import numpy as np
import pytest
from core_world import block, wall, wall_ahead, wall_left
from hypothesis import given, settings
from hypothesis import strategies as st
from infrared_world import drive, nexus, ring, scanned
from numpy.typing import NDArray
from pydantic import ValidationError
from scipy.signal import lfilter

from omnistudy.geometry import PlanarPose, PlanarTwist
from omnistudy.laws.infrared import InfraredLaw, sensor_directions
from omnistudy.plants.infrared_ring import InfraredRing
from omnistudy.scene import Body

LEFT, FRONT_LEFT, AHEAD_LEFT, AHEAD_RIGHT, FRONT_RIGHT, RIGHT = range(6)
STILL = PlanarTwist(0.0, 0.0, 0.0)


def standing(bodies: tuple[Body, ...], scans: int, **sensors: float) -> NDArray[np.float64]:
    """Ranges (scans, 6) that a robot that stands at the origin is told, one scan every 5 steps."""
    with nexus(*bodies, **sensors) as plant:
        scanned(plant)  # fills the filter
        return np.array([scan.ranges for scan in drive(plant, STILL, scans)])


def test_default_geometry_is_that_of_the_law() -> None:
    sensors, law = InfraredRing(), InfraredLaw()
    assert sensors.angles == pytest.approx(sensor_directions(law.oblique_angle))
    assert sensors.oblique == law.oblique_angle
    assert tuple(sensors.origins[FRONT_LEFT]) == (law.oblique_ahead, law.oblique_aside)


def test_the_right_half_mirrors_the_left() -> None:
    sensors = InfraredRing(oblique=0.5, side_ahead=0.03)
    assert sensors.angles == pytest.approx(-sensors.angles[::-1])
    assert sensors.origins == pytest.approx(sensors.origins[::-1] * (1.0, -1.0))
    assert sensors.angles[:3] == pytest.approx((pi / 2, pi / 2 - 0.5, 0.0))


def test_walls_are_seen_where_they_are() -> None:
    # ahead at 0.7: 0.5 before the front edge at 0.2. Left at 0.5: 0.32 beside the left edge at
    # 0.18, and 0.4·sqrt 2 along the oblique ray from (0.2, 0.1). Right: nothing, and the oblique
    # ray meets the wall ahead after 0.5·sqrt 2.
    with nexus(wall_ahead(0.7), wall_left(0.5)) as plant:
        scan = scanned(plant)
    expected = (0.32, 0.4 * sqrt(2), 0.5, 0.5, 0.5 * sqrt(2), 0.8)
    assert scan.ranges == pytest.approx(expected, abs=5e-4)
    assert scan.max_range == 0.8
    assert scan.origins == pytest.approx(ring().origins)


@pytest.mark.parametrize("heading", [0.3, -0.3])
def test_a_turned_robot_sees_the_wall_from_where_its_sensors_then_are(heading: float) -> None:
    with nexus(wall_ahead(0.7), start=PlanarPose(0.0, 0.0, heading)) as plant:
        scan = scanned(plant)
    for sensor, side in ((AHEAD_LEFT, 0.05), (AHEAD_RIGHT, -0.05)):
        sits = PlanarPose(0.0, 0.0, heading).to_world(0.2, side)[0]
        assert scan.ranges[sensor] == pytest.approx((0.7 - sits) / cos(heading), abs=5e-4)


def test_low_blocks_are_not_seen() -> None:
    assert (standing((block("red", 0.4, 0.0),), 1) == 0.8).all()


def test_what_is_too_near_reads_as_the_least_range_even_when_touched() -> None:
    with nexus(wall_ahead(0.5), min_range=0.04) as plant:
        ranges = [scan.ranges[AHEAD_LEFT] for scan in drive(plant, PlanarTwist(0.3, 0, 0), 100)]
        assert plant.state.contacts.walls == ("ahead",)
    assert ranges[-1] == 0.04
    assert min(ranges) == 0.04


def test_noise_has_the_sd_that_average_and_low_pass_leave() -> None:
    # 0.4 m is half of the 0.8 m where one reading has 20 mm: a quarter, 5 mm. The mean of four has
    # 2.5 mm. The filter keeps k = exp(-2π·8·5/240) of what was: sqrt((1 - k)/(1 + k)) of the SD.
    told = standing((wall_ahead(0.6),), 6000, noise=0.02, readings=4, cutoff=8.0)[:, AHEAD_LEFT]
    keep = exp(-2 * pi * 8 * 5 / 240)
    assert told.std() == pytest.approx(0.0025 * sqrt((1 - keep) / (1 + keep)), rel=0.04)
    assert told.mean() == pytest.approx(0.4, abs=2e-4)
    off = told - told.mean()
    assert (off[1:] @ off[:-1]) / (off @ off) == pytest.approx(keep, abs=0.04)


def test_noise_falls_with_the_square_of_the_distance_and_with_the_readings() -> None:
    near = standing((wall_ahead(0.4),), 3000, noise=0.02, readings=1)
    far = standing((wall_ahead(0.8),), 3000, noise=0.02, readings=16)
    assert near[:, AHEAD_LEFT].std() == pytest.approx(0.02 / 16, rel=0.05)
    assert far[:, AHEAD_RIGHT].std() == pytest.approx(0.02 * (0.6 / 0.8) ** 2 / 4, rel=0.05)
    correlation = np.corrcoef(near[:, AHEAD_LEFT], near[:, AHEAD_RIGHT])[0, 1]
    assert abs(correlation) < 0.06
    assert (near[:, LEFT] == 0.8).all()  # nothing seen, nothing to be noisy


def test_same_seed_same_bytes_another_seed_others() -> None:
    def told(seed: str) -> bytes:
        with nexus(wall_ahead(0.6), seed=seed, noise=0.02, interference=0.2) as plant:
            return b"".join(scan.ranges.tobytes() for scan in drive(plant, STILL, 20))

    assert told("a") == told("a") != told("b")


def test_the_low_pass_is_of_first_order() -> None:
    # past a post, so that sensors 3 and 4 see it come and 1 sees it jump
    post = wall("post", (1.0, 0.3), (1.0, 0.5))
    raw, filtered = [], []
    for cutoff, told in ((1e6, raw), (2.0, filtered)):
        with nexus(post, cutoff=cutoff) as plant:
            scanned(plant)
            told.extend(scan.ranges for scan in drive(plant, PlanarTwist(0.4, 0.0, 0.0), 150))
    keep = exp(-2 * pi * 2 * 5 / 240)
    by_hand, _ = lfilter([1 - keep], [1, -keep], raw, axis=0, zi=np.full((1, 6), keep * 0.8))
    assert np.ptp(raw, axis=0)[LEFT] > 0.5
    assert np.array(filtered) == pytest.approx(by_hand, abs=1e-9)


def slanted() -> Body:
    """A wall ahead that every sensor but 1 and 6 sees at another distance."""
    return wall("slanted", (0.3, 1.0), (0.6, -1.0))


def test_with_certain_interference_a_sensor_reads_a_neighbour() -> None:
    own = standing((slanted(),), 1)[0]
    near = own < 0.6
    told = standing((slanted(),), 200, interference=1.0, interference_range=0.6)
    for sensor in range(6):
        others = [own[i] for i in (sensor - 1, sensor + 1) if 0 <= i < 6 and near[i]]
        found = set(told[:, sensor].round(9))
        alone = {own[sensor]} if not near[sensor] or len(others) < 2 else set()
        wanted = alone | (set(others) if near[sensor] else set())
        assert found == {float(r) for r in np.round(sorted(wanted), 9)}, sensor
    assert near.sum() == 4


def test_interference_comes_as_often_as_asked_for() -> None:
    own = standing((slanted(),), 1)[0]
    told = standing((slanted(),), 4000, interference=0.3, interference_range=0.6)
    mistaken = (np.abs(told - own) > 1e-6).mean(axis=0)
    # sensors 3 and 4 have two neighbours that see something near, 2 and 5 have one, 1 and 6 none
    assert mistaken == pytest.approx((0, 0.15, 0.3, 0.3, 0.15, 0), abs=0.03)


def test_no_interference_where_only_one_sees_something_near() -> None:
    own = standing((wall_left(0.4),), 1)[0]
    assert (own < 0.4).sum() == 1
    told = standing((wall_left(0.4),), 50, interference=1.0)
    assert (told == own).all()


def test_rates_come_from_the_encoders() -> None:
    # a still wall square ahead: what the encoders tell is what happens
    with nexus(wall_ahead(3.0)) as plant:
        scan = drive(plant, PlanarTwist(0.2, 0.1, 0.5), 100)[-1]
    assert scan.rates is not None
    # at (0, 0.18) looking left: -vy; at (0.2, -0.05) looking ahead: -(vx - 0.5·(-0.05))
    assert scan.rates[LEFT] == pytest.approx(-0.1, abs=1e-3)
    assert scan.rates[AHEAD_RIGHT] == pytest.approx(-0.225, abs=1e-3)
    oblique = -((0.2 - 0.5 * 0.1) + (0.1 + 0.5 * 0.2)) / sqrt(2)
    assert scan.rates[FRONT_LEFT] == pytest.approx(oblique, abs=1e-3)


def test_rates_from_ranges_know_that_a_wall_is_slanted() -> None:
    # along a wall that comes nearer by 0.15 m a metre on the left: 0.3·0.15 m/s
    closing_in = wall("left", (-1.0, 0.75), (3.0, 0.15))
    rates = {}
    for source in ("encoders", "ranges"):
        with nexus(closing_in, rates_from=source) as plant:
            scanned(plant)
            scan = drive(plant, PlanarTwist(0.3, 0.0, 0.0), 60)[-1]
            assert scan.rates is not None
            rates[source] = scan.rates[LEFT]
    assert rates["encoders"] == pytest.approx(0.0, abs=1e-6)
    assert rates["ranges"] == pytest.approx(-0.3 * 0.15, rel=0.02)


@settings(max_examples=25)
@given(st.floats(-0.25, 0.15), st.floats(-0.3, 0.2), st.floats(-0.7, 0.7), st.floats(-1.0, 1.0))
def test_in_a_mirrored_world_the_law_gives_the_mirrored_wrench(
    x: float, y: float, heading: float, slant: float
) -> None:
    wrenches = []
    for side in (1.0, -1.0):
        walls = (
            wall("ahead", (0.75 - 0.3 * slant, -2 * side), (0.75 + 0.3 * slant, 2 * side)),
            wall("left", (-2.0, 0.65 * side), (2.0, 0.65 * side)),
        )
        with nexus(*walls, start=PlanarPose(x, side * y, side * heading)) as plant:
            drive(plant, PlanarTwist(0.1, side * 0.05, side * 0.2), 2)
            wrenches.append(InfraredLaw().wrench(scanned(plant), STILL))
    fx, fy, tau = wrenches[0]
    assert wrenches[1] == pytest.approx((fx, -fy, -tau), abs=0.02)


def test_before_the_first_scan_nothing_is_recorded() -> None:
    with nexus() as plant:
        names = [channel.name for channel in plant.channels]
        before = dict(zip(names, plant.values(), strict=True))
        scanned(plant)
        after = dict(zip(names, plant.values(), strict=True))
    assert np.isnan(before["infrared_1"])
    assert after["infrared_6"] == 0.8


def test_ranges_that_are_crossed_are_refused() -> None:
    with pytest.raises(ValidationError, match=r"min_range 0\.9 m must be below max_range 0\.8 m"):
        InfraredRing(min_range=0.9)

"""Rays of a replay are cast anew in the page; they are those that the robot's own sensor cast."""

from __future__ import annotations

from math import pi, sqrt
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from omnistudy.geometry import PlanarPose
from omnistudy.plants.nexus import Nexus
from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Box, Cylinder, Hinge, Scene
from omnistudy.view.chromium import Browser, Tab

from .made_films import RECORD, made_film, opened

pytestmark = pytest.mark.slow

LOW = Body(name="low", role="target", geometry=Box(x=0.1, y=0.1, z=0.1), x=-0.45, y=0.1, z=0.05)
GHOST = Body(
    name="ghost",
    role="finish",
    geometry=Box(x=0.1, y=0.1, z=0.8),
    x=-0.35,
    y=0.1,
    z=0.4,
    solid=False,
)
POST = Cylinder(radius=0.08, length=0.8)
DOOR = Body(
    name="door",
    role="door",
    geometry=Box(x=1.0, y=0.04, z=0.8),
    x=0.4,
    y=0.0,
    z=0.4,
    yaw=pi / 2,
    hinge=Hinge(x=-0.5),
    mass=1.0,
)


def wall(x: float, y: float, length: float, yaw: float) -> Body:
    box = Box(x=length, y=0.1, z=0.8)
    return Body(name=f"wall {x} {y}", role="wall", geometry=box, x=x, y=y, z=0.4, yaw=yaw)


def still(theta: float = 0.0, **others: tuple[float, float]) -> dict[str, tuple[float, float]]:
    """Two samples of a robot that stands at the origin."""
    rest = (0.0, 0.0)
    return {"t": (0.0, 1.0), "x": rest, "y": rest, "theta": (theta, theta), **others}


def ends(tab: Tab, t: float = 0.0) -> NDArray[np.float64]:
    """Where rays of the page meet something, (n, 2) m, robot frame."""
    rays = "window.replay.player.reels[0].rays"
    found = tab.value(f"{rays}.hits({RECORD}.at({t})).map(([from, to]) => to)")
    return np.array(found, dtype=np.float64).reshape(-1, 2)


def test_they_are_those_of_the_simulated_lidar(chromium: Browser, tmp_path: Path) -> None:
    post = Body(name="post", role="wall", geometry=POST, x=-0.45, y=-0.2, z=0.4)
    scene = Scene(bodies=(wall(0.2, 0.45, 2.0, 0.0), wall(0.5, -0.35, 1.0, 0.6), post, LOW, GHOST))
    plant = Youbot()
    running = plant.build(scene, PlanarPose(0.0, 0.0, 0.3), 240, "seed")
    try:
        scan = running.scan()
    finally:
        running.close()
    assert scan is not None
    met = scan.ranges < scan.max_range
    assert 20 < met.sum() < 120
    tab = opened(chromium, made_film(plant, scene, still(0.3)), tmp_path)
    assert ends(tab) == pytest.approx(scan.points()[met], abs=2e-3)
    assert tab.faults == []


def test_an_open_door_lets_rays_through_and_stops_others(chromium: Browser, tmp_path: Path) -> None:
    """Shut, it stands across 0.4 m ahead; open, along y = -0.5 m from x = -0.6 to 0.4 m."""
    values = still(hinge_door=(0.0, pi / 2))
    tab = opened(chromium, made_film(Youbot(), Scene(bodies=(DOOR,)), values), tmp_path)
    shut, wide = ends(tab, 0.0), ends(tab, 1.0)
    assert shut[:, 0] == pytest.approx(0.38)
    assert wide[:, 1] == pytest.approx(-0.48)
    assert wide[:, 0].min() < -0.3


def test_infrared_rays_start_where_their_sensors_sit(chromium: Browser, tmp_path: Path) -> None:
    """The last sensor looks to the right, where nothing is."""
    scene = Scene(bodies=(wall(0.75, 0.0, 4.0, pi / 2), wall(0.0, 0.55, 4.0, 0.0)))
    tab = opened(chromium, made_film(Nexus(), scene, still()), tmp_path)
    ranges = (0.32, 0.4 * sqrt(2), 0.5, 0.5, 0.5 * sqrt(2))
    sight = Nexus().sight
    assert sight is not None
    places = zip(sight.origins[:5], sight.angles[:5], ranges, strict=True)
    told = [(x + r * np.cos(angle), y + r * np.sin(angle)) for (x, y), angle, r in places]
    assert ends(tab) == pytest.approx(np.array(told), abs=1e-6)

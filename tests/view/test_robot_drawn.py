"""Robots and worlds are drawn where their channels say: doors turn, drawers and lifts slide."""

from __future__ import annotations

from math import pi
from pathlib import Path

import pytest

from omnistudy.plants.youbot import Youbot
from omnistudy.scene import Body, Box, Hinge, Joint, Link, Scene
from omnistudy.view.chromium import Browser, Tab

from .made_films import made_film, opened

pytestmark = pytest.mark.slow

STAGE = "window.replay.player.reels[0].stage"
DOOR = Body(
    name="door",
    role="door",
    geometry=Box(x=1.0, y=0.04, z=0.8),
    x=2.0,
    y=1.0,
    z=0.4,
    hinge=Hinge(x=-0.5),
    mass=5.0,
)
REST = (0.0, 0.0)
STILL = {"t": (0.0, 1.0), "x": REST, "y": REST, "theta": REST}


class Cupboard(Youbot):
    """SYNTHETIC: a base that carries a box with a drawer, which is tilted by 90 degrees."""

    @property
    def links(self) -> tuple[Link, ...]:
        """The box, and the drawer in it, whose own x points up."""
        box = Link(name="box", geometry=Box(x=0.4, y=0.4, z=0.4), z=0.3)
        slides = Joint(channel="drawer", axis=(1.0, 0.0, 0.0), motion="slide")
        front = Box(x=0.1, y=0.3, z=0.3)
        drawer = Link(
            name="drawer", parent="box", geometry=front, x=0.1, pitch=-pi / 2, joint=slides
        )
        return (box, drawer)


def place(tab: Tab, thing: str, t: float) -> list[float]:
    """Where the middle of something drawn is at a time, m."""
    tab.value(f"window.replay.seek({t})")
    found = tab.value(
        f"(() => {{ const one = {thing}; one.updateWorldMatrix(true, false);"
        " return one.getWorldPosition(one.position.clone()).toArray(); })()"
    )
    return [float(value) for value in found]


def test_a_door_turns_about_its_hinge(chromium: Browser, tmp_path: Path) -> None:
    """The leaf of 1 m hangs at (1.5, 1.0); a quarter turn to the left puts its middle at 1.5 m."""
    film = made_film(Youbot(), Scene(bodies=(DOOR,)), {**STILL, "hinge_door": (0.0, pi / 2)})
    tab = opened(chromium, film, tmp_path)
    leaf = f"{STAGE}.world.doors[0][1].children[0]"
    assert place(tab, leaf, 0.0) == pytest.approx([2.0, 1.0, 0.4])
    assert place(tab, leaf, 1.0) == pytest.approx([1.5, 1.5, 0.4], abs=1e-6)
    assert tab.faults == []


def test_a_drawer_slides_along_its_own_axis(chromium: Browser, tmp_path: Path) -> None:
    film = made_film(Cupboard(), Scene(bodies=()), {**STILL, "drawer": (0.0, 0.25)})
    tab = opened(chromium, film, tmp_path)
    drawer = f"{STAGE}.robot.moving[0].frame"
    assert place(tab, drawer, 0.0) == pytest.approx([0.1, 0.0, 0.3])
    assert place(tab, drawer, 1.0) == pytest.approx([0.1, 0.0, 0.55])


def test_what_has_no_place_of_its_own_stands_at_the_start(
    chromium: Browser, tmp_path: Path
) -> None:
    """As an arm on a foot does; the made world's start is 0.5 m ahead."""
    film = made_film(Cupboard(), Scene(bodies=()), {"t": (0.0, 1.0), "drawer": (0.0, 0.25)})
    tab = opened(chromium, film, tmp_path)
    drawer = f"{STAGE}.robot.moving[0].frame"
    assert place(tab, drawer, 1.0) == pytest.approx([0.6, 0.0, 0.55])
    assert tab.faults == []

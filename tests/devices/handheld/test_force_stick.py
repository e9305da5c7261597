"""A force-feedback stick through Linux's event device, which umockdev fakes."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from typing import Any

import pytest
from fake_system import FakeSystem, missing, process_inside

from omnistudy.devices import NO_HAND, Identity
from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.handheld.force_effects import Strength
from omnistudy.devices.handheld.force_stick import ForceStick
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.sdl_stick import SdlStick
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.geometry import ForceField, PlanarWrench
from omnistudy.geometry.force_field import ZERO_MATRIX

FULL = Travel()
X, Y, RZ, TRIGGER = 0x00, 0x01, 0x05, 0x120
SPRING = ((60.0, 0.0, 0.0), (0.0, 30.0, 0.0), (0.0, 0.0, 0.0))
DAMPER = ((5.0, 0.0, 0.0), (0.0, 2.5, 0.0), (0.0, 0.0, 0.0))
HALF = Strength(force=5.0, speed=0.2)


def wait_until(true: Callable[[], bool], seconds: float = 30.0) -> None:
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "it never came true"
        time.sleep(0.01)


class Stick:
    """The fake stick and our device on it."""

    def __init__(self, system: FakeSystem, process: Any, device: Handheld) -> None:
        self.say = system.say
        self._opened = process.Opened(device, 250)

    def ask(self, name: str, *arguments: Any) -> Any:
        return self._opened.ask(name, *arguments)

    def advance(self) -> tuple[float, ...]:
        position: tuple[float, ...] = self.ask("advance", NO_HAND).position
        return position

    def did(self, what: str) -> list[dict[str, Any]]:
        return [one for one in self.say("log") if one["do"] == what]


@pytest.fixture
def plug_in() -> Iterator[Callable[..., Stick]]:
    lacking = missing()
    if lacking:
        pytest.skip(f"needs {lacking}")
    with ExitStack() as ending:

        def plug(device: Handheld | None = None, motors: str = "full") -> Stick:
            system = FakeSystem("fake_force_stick.py", motors)
            ending.callback(system.close)
            process = ending.enter_context(process_inside(system))
            return Stick(system, process, device or ForceStick())

        yield plug


def test_its_axes_are_read_to_the_newest(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in()
    assert stick.advance() == pytest.approx((0.0, 0.0, 0.0), abs=FULL.x / 1000)
    for value in range(-512, 512):
        stick.say(f"move {X} {value}")
    stick.say(f"move {Y} -512")
    stick.say(f"move {RZ} 31")
    assert stick.advance() == (FULL.x, -FULL.y, -FULL.theta)
    assert stick.ask("identity") == Identity("Fake SideWinder FFB2", "FF2-0042")
    assert stick.ask("health").ticks == 2


def test_after_lost_events_it_asks_where_all_is(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in()
    stick.advance()
    stick.say("overflow")
    assert stick.advance()[1] == -FULL.y


def test_a_field_becomes_three_effects_that_die_by_themselves(
    plug_in: Callable[..., Stick],
) -> None:
    # 5 N at full effect: 60 N/m on 0.0415 m is 0.497 of it, 5 N·s/m at 0.2 m/s is 0.2 of it
    stick = plug_in(ForceStick(strength=HALF))
    stick.advance()
    stick.ask("render", ForceField(PlanarWrench(2.5, 0.0, 9.0), (0, 0, 0), SPRING, DAMPER, 0.1))
    push, spring, damper = stick.did("upload")
    assert push["level"] == pytest.approx(0.5 * 0x7FFF, abs=100)
    assert push["direction"] == pytest.approx(0x8000, abs=100)  # away from the user: forward
    assert (push["length"], push["fade"], push["fade_level"]) == (200, 100, 0)
    assert spring["kind"], damper["kind"] == ("spring", "damper")
    assert (spring["length"], damper["length"]) == (100, 100)
    across, along = spring["axes"]
    assert along["right"] == along["left"] == round(60.0 * FULL.x / 5.0 * 0x7FFF)
    assert across["right"] == round(30.0 * FULL.y / 5.0 * 0x7FFF)
    assert along["right_saturation"] == 0xFFFF
    assert [axis["right"] for axis in damper["axes"]] == [round(0.1 * 0x7FFF), round(0.2 * 0x7FFF)]
    assert [one["slot"] for one in stick.did("play")] == [0, 1, 2]
    assert stick.ask("forces") == (True, True, False)
    assert stick.ask("wrench") == "clipped"


def test_where_a_push_pulls_to(plug_in: Callable[..., Stick]) -> None:
    # linux/input.h: 0x0000 down, 0x4000 left, 0x8000 up, 0xC000 right
    stick = plug_in()
    for fx, fy in ((1, 0), (0, 1), (-1, 0), (0, -1), (1, 1)):
        stick.ask("render", ForceField(PlanarWrench(fx, fy, 0.0)))
    pulled = [one["direction"] for one in stick.did("upload") if one["kind"] == "push"]
    assert pulled == [0x8000, 0x4000, 0x0000, 0xC000, 0x6000]


def test_a_spring_s_centre_is_where_the_law_says(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in()
    about = (0.5 * FULL.x, 0.25 * FULL.y, 0.0)
    stick.ask("render", ForceField(PlanarWrench(0, 0, 0), about, SPRING))
    across, along = stick.did("upload")[1]["axes"]
    # forward is less on Linux's Y, left is less on its X
    assert along["centre"] == round(-0.5 * 0x7FFF)
    assert across["centre"] == round(-0.25 * 0x7FFF)


def test_effects_keep_their_slots_and_only_changes_are_uploaded(
    plug_in: Callable[..., Stick],
) -> None:
    stick = plug_in()
    for step in range(40):
        push = 0.1 * (step // 2)
        stick.ask("render", ForceField(PlanarWrench(push, 0, 0), (0, 0, 0), SPRING, DAMPER))
    uploads = stick.did("upload")
    assert {one["slot"] for one in uploads} == {0, 1, 2}
    assert len(uploads) == 20 + 1 + 1
    assert len(stick.did("play")) == 3 * 40


def test_the_stick_s_own_centring_is_off_and_closing_leaves_no_effect(
    plug_in: Callable[..., Stick],
) -> None:
    stick = plug_in()
    stick.ask("render", ForceField(PlanarWrench(1, 0, 0), (0, 0, 0), SPRING))
    assert stick.did("gain") == [{"do": "gain", "value": 0xFFFF}]
    assert stick.did("autocentre") == [{"do": "autocentre", "value": 0}]
    stick.ask("close")
    assert sorted(one["slot"] for one in stick.did("erase")) == [0, 1, 2]


def test_what_was_commanded_is_told_clipped(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in(ForceStick(strength=HALF))
    stick.ask("render", ForceField(PlanarWrench(9.0, 0.0, 3.0)))
    stick.advance()
    assert stick.ask("values") == pytest.approx((5.0, 0.0))
    assert stick.ask("health").saturated == (1, 0, 0)
    stick.ask("render", ForceField(PlanarWrench(0.0, 2.0, 0.0)))
    stick.advance()
    assert stick.ask("values") == pytest.approx((0.0, 2.0))
    assert stick.ask("health").saturated == (1, 0, 0)
    assert [one.name for one in stick.ask("channels")] == ["commanded_x", "commanded_y"]


def test_without_springs_the_push_holds_the_spring_s_force(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in(motors="push")
    stick.say(f"move {Y} -512")
    assert stick.advance()[0] == FULL.x
    stick.ask("render", ForceField(PlanarWrench(0, 0, 0), (0, 0, 0), SPRING))
    (push,) = stick.did("upload")
    assert push["level"] == pytest.approx(60.0 * FULL.x / 5.0 * 0x7FFF, abs=20)
    assert push["direction"] == pytest.approx(0x0000, abs=20)  # back to the user


def test_unplugged_it_rests_says_so_and_nothing_is_raised(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in()
    stick.say(f"move {X} 511")
    stick.advance()
    stick.say("unplug")
    assert stick.advance() == (0.0, 0.0, 0.0)
    told = "'Fake SideWinder FFB2' (serial number FF2-0042) was unplugged"
    assert stick.ask("trouble") == told
    stick.ask("render", ForceField(PlanarWrench(1, 0, 0)))
    stick.ask("close")


@pytest.mark.slow
def test_sdl_renders_the_same_effects(plug_in: Callable[..., Stick]) -> None:
    field = ForceField(PlanarWrench(1.0, -2.0, 0.0), (0.01, 0, 0), SPRING, DAMPER, 0.1)
    told = []
    for device in (ForceStick(strength=HALF), SdlStick(strength=HALF)):
        stick = plug_in(device)
        stick.advance()
        stick.ask("render", field)
        assert stick.ask("forces") == (True, True, False)
        told.append({one.pop("kind"): one for one in stick.did("upload")})
        stick.ask("close")
    ours, by_sdl = told
    assert by_sdl["push"]["level"] == pytest.approx(ours["push"]["level"], abs=200)
    assert by_sdl["push"]["direction"] == pytest.approx(ours["push"]["direction"], abs=200)
    for kind in ("spring", "damper"):
        for mine, theirs in zip(ours[kind]["axes"], by_sdl[kind]["axes"], strict=True):
            assert theirs == pytest.approx(mine, abs=2)
        assert ours[kind]["length"] == by_sdl[kind]["length"]
    assert ours["push"]["fade"] == by_sdl["push"]["fade"]


def test_nothing_at_all_is_felt_of_a_law_without_force(plug_in: Callable[..., Stick]) -> None:
    stick = plug_in()
    stick.ask("render", ForceField(PlanarWrench(0, 0, 0), (0, 0, 0), ZERO_MATRIX))
    push, spring, damper = stick.did("upload")
    assert push["level"] == 0
    assert {axis["right"] for one in (spring, damper) for axis in one["axes"]} == {0}


def test_in_a_process_of_its_own_it_is_driven_renders_and_is_unplugged() -> None:
    lacking = missing()
    if lacking:
        pytest.skip(f"needs {lacking}")
    system = FakeSystem("fake_force_stick.py", "full")
    with system.inside():
        device = RemoteDevice(ForceStick())
    told = device.introduction
    assert told.identity == Identity("Fake SideWinder FFB2", "FF2-0042")
    assert (told.forces, told.wrench) == ((True, True, False), "clipped")
    device.open_trial(1)
    system.say(f"move {Y} -512")
    device.render(ForceField(PlanarWrench(1.0, 0, 0), (0, 0, 0), SPRING))
    wait_until(lambda: device.advance(NO_HAND).position[0] == FULL.x)
    wait_until(lambda: any(one.get("level") for one in system.say("log")))
    system.say("unplug")
    wait_until(lambda: "was unplugged" in device.trouble())
    assert device.advance(NO_HAND).position == (0.0, 0.0, 0.0)
    device.close()
    system.close()

"""A SpaceMouse through hidapi and Linux's raw HID device, which umockdev fakes."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from typing import Any

import pytest
from fake_system import FakeSystem, missing, process_inside

from omnistudy.devices import NO_HAND, Identity
from omnistudy.devices.handheld.axes import Travel
from omnistudy.devices.handheld.choice import Attached
from omnistudy.devices.handheld.space_mouse import SpaceMouse

FULL = Travel()
REST = (0.0, 0.0, 0.0)


class Mouse:
    """The fake mouse and our device on it."""

    def __init__(self, system: FakeSystem, process: Any) -> None:
        self.say = system.say
        self.attached = process.attached
        self._opened = process.Opened(SpaceMouse(), 250)

    def ask(self, name: str, *arguments: Any) -> Any:
        return self._opened.ask(name, *arguments)

    def advance(self) -> tuple[float, ...]:
        position: tuple[float, ...] = self.ask("advance", NO_HAND).position
        return position


@pytest.fixture
def mouse() -> Iterator[Mouse]:
    lacking = missing()
    if lacking:
        pytest.skip(f"needs {lacking}")
    with ExitStack() as ending:
        system = FakeSystem("fake_space_mouse.py")
        ending.callback(system.close)
        yield Mouse(system, ending.enter_context(process_inside(system)))


def test_forward_left_and_counter_clockwise(mouse: Mouse) -> None:
    # 350 to the right, to the user and clockwise are 5e01; the other way a2fe
    assert mouse.advance() == REST
    mouse.say("send 01a2fea2fe0000")
    mouse.say("send 0200000000a2fe")
    assert mouse.advance() == (FULL.x, FULL.y, FULL.theta)
    mouse.say("send 015e010000ffff")
    assert mouse.advance() == (0.0, -FULL.y, FULL.theta)
    assert mouse.ask("identity") == Identity("SpaceMouse Compact", "SM-7")
    listed = mouse.attached(
        "omnistudy.devices.handheld.space_mouse_hardware", "attached_space_mice"
    )
    assert listed._getvalue() == (
        Attached("space_mouse", "SpaceMouse Compact", "SM-7", "/dev/hidraw0"),
    )


def test_release_is_rest_within_one_tick_however_much_came_before(mouse: Mouse) -> None:
    mouse.advance()
    for _ in range(200):
        mouse.say("send 01a2fea2fe0000")
    mouse.say("send 01000000000000")
    assert mouse.advance() == REST
    assert mouse.say("waiting") == 0


def test_unplugged_it_rests_and_says_so(mouse: Mouse) -> None:
    mouse.say("send 01a2fea2fe0000")
    assert mouse.advance() == (FULL.x, FULL.y, 0.0)
    mouse.say("unplug")
    assert mouse.advance() == REST
    assert mouse.ask("trouble") == "'SpaceMouse Compact' (serial number SM-7) was unplugged"
    mouse.ask("close")

"""Gamepads and twist sticks through SDL2 and its virtual joystick."""

from __future__ import annotations

from math import exp

import pytest
from virtual_joystick import VirtualJoystick, in_a_child

from omnistudy.devices import NO_HAND, Identity
from omnistudy.devices.handheld import before_driving
from omnistudy.devices.handheld.axes import AxisMap, Travel
from omnistudy.devices.handheld.before_driving import LET_GO
from omnistudy.devices.handheld.sdl_hardware import attached_sdl_sticks
from omnistudy.devices.handheld.sdl_stick import SdlStick
from omnistudy.errors.handheld import (
    AnotherDevice,
    CannotOpen,
    NoSuchAxis,
    NotAtRest,
    NothingPluggedIn,
    WhichDevice,
)
from omnistudy.session.parts import part

FULL = Travel()


@in_a_child
def test_a_gamepad_drives_with_one_stick_and_turns_with_the_other() -> None:
    there = VirtualJoystick(gamepad=True)
    device = part("device", "gamepad").connect(250)
    assert device.advance(NO_HAND).position == (0.0, 0.0, 0.0)
    there.move(0, -32768)  # left stick to the left
    there.move(1, -32768)  # and forward
    there.move(2, 32767)  # right stick to the right: clockwise
    assert device.advance(NO_HAND).position == (FULL.x, FULL.y, -FULL.theta)
    for axis in range(3):
        there.move(axis, 3000)  # what a worn stick tells at rest
    assert device.advance(NO_HAND).position == (0.0, 0.0, 0.0)
    device.close()


@in_a_child
def test_a_twist_stick_turns_by_its_twist() -> None:
    there = VirtualJoystick("T.16000M")
    device = part("device", "twist_stick").connect(250)
    there.move(2, -32768)
    assert device.advance(NO_HAND).position == (0.0, 0.0, FULL.theta)
    there.move(1, 32767)
    there.move(2, 0)
    assert device.advance(NO_HAND).position == (-FULL.x, 0.0, 0.0)
    assert device.identity() == Identity("T.16000M")
    device.close()


@in_a_child
def test_hats_buttons_and_triggers_can_be_axes() -> None:
    there = VirtualJoystick(gamepad=True)
    by_triggers = AxisMap(axis="left_trigger", opposite="right_trigger")
    pad = part("device", "gamepad").model_copy(update={"theta": by_triggers}).connect(250)
    by_buttons = AxisMap(axis="button_3", opposite="button_2")
    stick = SdlStick(theta=by_buttons, x=AxisMap(axis="hat_0_y", sign=-1)).connect(250)
    there.move(4, 32767)
    there.press(2)
    there.point(up=True)
    assert pad.advance(NO_HAND).position[2] == pytest.approx(FULL.theta)
    assert stick.advance(NO_HAND).position == (FULL.x, 0.0, -FULL.theta)


@in_a_child
def test_the_rate_is_the_smoothed_difference_of_positions() -> None:
    there = VirtualJoystick()
    sharp = SdlStick(rate_smoothing=0.0).connect(250)
    smooth = SdlStick(rate_smoothing=0.02).connect(250)
    for device in (sharp, smooth):
        device.advance(NO_HAND)
    there.move(1, -32768)
    step = FULL.x * 250  # the whole way in one tick
    assert sharp.advance(NO_HAND).rate[0] == pytest.approx(step)
    assert smooth.advance(NO_HAND).rate[0] == pytest.approx(step * (1 - exp(-0.2)))
    assert sharp.advance(NO_HAND).rate == (0.0, 0.0, 0.0)
    moved = [smooth.advance(NO_HAND).rate[0] for _ in range(100)]
    assert moved[4] == pytest.approx(step * (1 - exp(-0.2)) * exp(-1.0))
    assert smooth.rows() == ((FULL.x, 0.0, 0.0, moved[-1], 0.0, 0.0),)


@in_a_child
def test_an_unplugged_stick_rests_and_says_so() -> None:
    there = VirtualJoystick()
    device = SdlStick().connect(250)
    there.move(1, -32768)
    assert device.advance(NO_HAND).position[0] == FULL.x
    assert device.trouble() == ""
    there.unplug()
    state = device.advance(NO_HAND)
    assert (state.position, state.rate) == ((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))
    assert device.trouble() == "'Virtual Stick' was unplugged"
    VirtualJoystick("Virtual Stick").move(1, -32768)  # another one does not take its place
    assert device.advance(NO_HAND).position == (0.0, 0.0, 0.0)
    assert device.trouble()
    device.close()


@in_a_child
def test_of_several_the_page_says_which() -> None:
    with pytest.raises(NothingPluggedIn, match="nothing of its kind is there"):
        SdlStick().connect(250).advance(NO_HAND)
    VirtualJoystick("Left stick")
    other = VirtualJoystick("Right stick")
    assert [one.name for one in attached_sdl_sticks()] == ["Left stick", "Right stick"]
    with pytest.raises(WhichDevice, match="'Left stick', 'Right stick'"):
        SdlStick().connect(250).advance(NO_HAND)
    with pytest.raises(NothingPluggedIn, match="with name 'wheel' is not plugged in"):
        SdlStick(name="wheel").connect(250).advance(NO_HAND)
    device = SdlStick(name="right").connect(250)
    other.move(0, 32767)
    assert device.advance(NO_HAND).position == (0.0, -FULL.y, 0.0)
    with pytest.raises(NoSuchAxis, match="no axis 'axis_9'"):
        SdlStick(name="left", x=AxisMap(axis="axis_9")).connect(250).advance(NO_HAND)


@in_a_child
def test_before_driving_it_must_rest(monkeypatch: pytest.MonkeyPatch) -> None:
    there = VirtualJoystick()
    asked: list[str] = []
    found = SdlStick().before_force(asked.append)
    assert ([one.name for one in found], asked) == (["check_identity", "check_rest"], [])

    def let_go(sentence: str) -> None:
        asked.append(sentence)
        there.move(1, 0)

    there.move(1, 20000)
    SdlStick().before_force(let_go)
    assert asked == [LET_GO]
    there.move(1, 20000)
    monkeypatch.setattr(before_driving, "PATIENCE_S", 0.05)
    with pytest.raises(NotAtRest, match="did not come to rest within"):
        SdlStick().before_force(asked.append)


@in_a_child
def test_after_trouble_it_must_be_the_one_that_was_driven_with() -> None:
    VirtualJoystick("Stick A")
    SdlStick().before_force(print, Identity("Stick A"))
    with pytest.raises(AnotherDevice, match="'Stick A' is plugged in where 'Stick B' was"):
        SdlStick().before_force(print, Identity("Stick B"))


@in_a_child
def test_a_stick_without_motors_says_so() -> None:
    VirtualJoystick()
    device = SdlStick().connect(250)
    device.advance(NO_HAND)
    assert (device.forces, device.channels, device.wrench) == ((False,) * 3, (), "none")


@in_a_child
def test_what_sdl_does_not_know_is_no_gamepad() -> None:
    VirtualJoystick(gamepad=False)
    with pytest.raises(CannotOpen, match="put 'read_as: joystick'"):
        part("device", "gamepad").connect(250).advance(NO_HAND)


def test_nothing_is_opened_to_be_described() -> None:
    device = SdlStick().connect(250)
    assert [axis.name for axis in device.axes] == ["stick_x", "stick_y", "stick_theta"]
    assert device.trouble() == ""
    device.close()

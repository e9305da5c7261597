"""`omnistudy device` with a gamepad: list, check, monitor, calibrate."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from io import StringIO
from pathlib import Path
from typing import NamedTuple

import pytest
import yaml
from virtual_joystick import VirtualJoystick, in_a_child

from omnistudy.cli.app import main
from omnistudy.devices import NO_HAND
from omnistudy.devices.handheld import calibrating
from omnistudy.devices.handheld.axes import Travel
from omnistudy.session.parts import part

FORWARD, LEFT, TURNED = (1, -30000), (0, -29000), (2, -31000)
BACK, RIGHT, TURNED_BACK = (1, 28000), (0, 27000), (2, 26000)


class Said(NamedTuple):
    out: str
    err: str
    status: int


def omnistudy(*words: str, hands: Iterator[object] | None = None) -> Said:
    """Run a command in this process; each line that it asks for moves `hands` on."""

    class Keys:
        def readline(self) -> str:
            answer = next(hands, "") if hands else ""
            return answer if isinstance(answer, str) else "\n"

    out, err = StringIO(), StringIO()
    with pytest.MonkeyPatch.context() as patch, redirect_stdout(out), redirect_stderr(err):
        patch.setattr(sys, "argv", ["omnistudy", *words])
        patch.setattr(sys, "stdin", Keys())
        with pytest.raises(SystemExit) as end:
            main()
    return Said(out.getvalue(), err.getvalue(), int(end.value.code or 0))


def hands_on(there: VirtualJoystick) -> Iterator[None]:
    """Do what is asked: let go, then hold each end."""
    for axis in range(3):
        there.move(axis, 0)
    yield
    for axis, value in (FORWARD, BACK, LEFT, RIGHT, TURNED, TURNED_BACK):
        there.move(axis, value)
        yield
        there.move(axis, 0)


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path], None]:
    def in_lab(lab: Path) -> None:
        monkeypatch.setattr(calibrating, "HELD_S", 0.02)
        monkeypatch.setenv("OMNISTUDY_CONF", str(lab))

    return in_lab


@in_a_child
def test_what_is_plugged_in_is_listed() -> None:
    VirtualJoystick("T.16000M")
    listed = json.loads(omnistudy("device", "list", "--json").out)
    assert {"kind": "sdl_stick", "name": "T.16000M", "serial": "", "path": "0"} in listed[
        "plugged_in"
    ]
    assert listed["remarks"] == []
    assert "T.16000M" in omnistudy("device", "list").out


@pytest.mark.slow
@in_a_child
def test_a_gamepad_is_checked(tmp_path: Path) -> None:
    there = VirtualJoystick("Pad", gamepad=True)
    said = omnistudy("device", "check", "gamepad", "--json")
    found = {one["what"]: one for one in json.loads(said.out)}
    assert said.status == 0
    assert found["model"]["found"] == "Pad"
    assert found["force"]["found"] == "on no axis"
    assert found["moves the stick"]["found"] == "x by left_y, y by left_x, theta by right_x"
    assert found["real time"]["sound"]
    there.move(1, 32767)
    said = omnistudy("device", "check", "gamepad")
    assert "x moved" in said.out
    assert said.status == 1


@in_a_child
def test_a_gamepad_is_watched() -> None:
    there = VirtualJoystick(gamepad=True)
    there.move(1, -32768)
    there.press(0)
    said = omnistudy("device", "monitor", "gamepad", "--seconds", "0.05")
    assert said.status == 0
    assert "x +0.0415 m  y +0.0000 m" in said.out
    assert "left_y -32768, a 1" in said.out
    told = json.loads(omnistudy("device", "monitor", "gamepad", "--seconds", "0.05", "--json").out)
    assert told["tells"]["left_y"] == -32768


@in_a_child
def test_a_calibration_is_led_through_and_becomes_the_lab_s_page(
    tmp_path: Path, quick: Callable[[Path], None]
) -> None:
    quick(tmp_path)
    there = VirtualJoystick("Pad", gamepad=True)
    said = omnistudy("device", "calibrate", "gamepad", hands=hands_on(there))
    assert said.status == 0, said.err
    assert "1 of 7: let go of it" in said.err
    assert "2 of 7: hold it all the way forward" in said.err
    page = yaml.safe_load((tmp_path / "device" / "gamepad.yaml").read_text())
    assert page["x"]["range"] == {"low": -29400.0, "centre": 0.0, "high": 27440.0}
    assert page["x"]["axis"] == "left_y"
    assert page["read_as"] == "gamepad"
    assert page["calibrated"].endswith(", Pad")
    device = part("device", "gamepad").connect(250)
    there.move(2, 0)
    there.move(1, -29500)
    assert device.advance(NO_HAND).position == (Travel().x, 0.0, 0.0)


@in_a_child
def test_a_page_is_replaced_only_when_that_is_wanted(
    tmp_path: Path, quick: Callable[[Path], None]
) -> None:
    quick(tmp_path)
    there = VirtualJoystick(gamepad=True)
    file = tmp_path / "device" / "mine.yaml"
    file.parent.mkdir()
    file.write_text("kind: sdl_stick  # mine\n")
    verb = ("device", "calibrate", "gamepad", "--page", "mine")
    dry = omnistudy(*verb, "--dry-run", "--json", hands=hands_on(there))
    assert dry.status == 0
    assert json.loads(dry.out)["written"] is False
    assert json.loads(dry.out)["axes"][0]["noise"] == 0.0
    refused = omnistudy(*verb, hands=iter(["n\n"]))
    assert refused.status == 1
    assert "mine.yaml is there: replace it?" in refused.err
    assert file.read_text() == "kind: sdl_stick  # mine\n"
    assert omnistudy(*verb, "--replace", hands=hands_on(there)).status == 0
    assert "calibrated" in file.read_text()


@in_a_child
def test_nothing_is_written_of_a_calibration_that_failed(
    tmp_path: Path, quick: Callable[[Path], None]
) -> None:
    quick(tmp_path)
    VirtualJoystick(gamepad=True)
    said = omnistudy("device", "calibrate", "gamepad", hands=iter([None] * 7))
    assert said.status == 1
    assert "axis 'left_y' did not move while it was to be held all the way forward" in said.err
    assert not list(tmp_path.iterdir())


@in_a_child
def test_a_device_that_goes_away_meanwhile_is_said_to(
    tmp_path: Path, quick: Callable[[Path], None]
) -> None:
    quick(tmp_path)
    there = VirtualJoystick("Pad", gamepad=True)

    def hands() -> Iterator[None]:
        yield
        there.unplug()
        yield

    said = omnistudy("device", "calibrate", "gamepad", hands=hands())
    assert said.status == 1
    assert "'Pad' was unplugged: plug it in and begin again" in said.err


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("check", "direct"), "error: device 'direct' is no hardware, there is nothing to check"),
        (("calibrate", "keyboard"), "error: device 'keyboard' has no axes whose ranges"),
        (("monitor", "gamepda"), "did you mean 'gamepad'?"),
    ],
)
def test_what_cannot_be_done_is_one_sentence(words: tuple[str, ...], sentence: str) -> None:
    said = omnistudy("device", *words)
    assert said.status == 1
    assert sentence in said.err
    assert "Traceback" not in said.err

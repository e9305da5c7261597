"""What is plugged in, and what cannot be looked for."""

from __future__ import annotations

import sys

import pytest

from omnistudy.devices import NO_HAND
from omnistudy.devices.handheld.force_stick import ForceStick
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.plugged_in import plugged_in
from omnistudy.devices.handheld.sdl_stick import SdlStick
from omnistudy.devices.handheld.space_mouse import SpaceMouse
from omnistudy.errors.handheld import NoDriver

EXTRA = "pip install 'omnistudy[devices]'"
NEEDED = [(SdlStick(), "sdl2"), (ForceStick(), "evdev"), (SpaceMouse(), "hidraw")]


def lose(monkeypatch: pytest.MonkeyPatch, library: str, failure: ImportError) -> None:
    """Let a library be missing."""

    class Missing:
        def find_spec(self, name: str, *_: object) -> None:
            if name == library:
                raise failure

    monkeypatch.delitem(sys.modules, library, raising=False)
    monkeypatch.setattr(sys, "meta_path", [Missing(), *sys.meta_path])


@pytest.mark.parametrize(("device", "library"), NEEDED)
def test_a_missing_library_is_one_sentence(
    monkeypatch: pytest.MonkeyPatch, device: Handheld, library: str
) -> None:
    lose(monkeypatch, library, ModuleNotFoundError(library))
    with pytest.raises(NoDriver) as refused:
        device.connect(250).advance(NO_HAND)
    assert f"device '{device.kind}' needs the Python package" in str(refused.value)
    assert EXTRA in str(refused.value)


def test_a_missing_system_library_names_its_package(monkeypatch: pytest.MonkeyPatch) -> None:
    lose(monkeypatch, "sdl2", ImportError("could not find any library for SDL2"))
    with pytest.raises(NoDriver, match=r"library SDL2, .*: apt-get install libsdl2-2.0-0"):
        SdlStick().connect(250).advance(NO_HAND)


def test_what_cannot_be_looked_for_hides_nothing_else(monkeypatch: pytest.MonkeyPatch) -> None:
    for _, library in NEEDED:
        lose(monkeypatch, library, ModuleNotFoundError(library))
    found = plugged_in()
    assert [one.kind for one in found.attached if one.kind != "serial_stick"] == []
    assert len(found.unseen) == 3
    assert all(EXTRA in reason for reason in found.unseen)

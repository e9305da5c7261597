"""Which of several devices a page means."""

from __future__ import annotations

import pytest

from omnistudy.devices.handheld.choice import Attached, the_one
from omnistudy.errors.handheld import NothingPluggedIn, WhichDevice

ONE, OTHER = (Attached("sdl_stick", "T.16000M", serial, "0") for serial in ("A1", "B2"))


def test_two_of_a_make_are_told_apart_by_serial_number() -> None:
    assert the_one("sdl_stick", (ONE, OTHER), "t.16000", "B2") == OTHER
    with pytest.raises(WhichDevice, match=r"serial number A1\), 'T.16000M' \(serial number B2"):
        the_one("sdl_stick", (ONE, OTHER), "T.16000M", "")


def test_another_one_of_the_same_make_is_not_taken_for_it() -> None:
    with pytest.raises(
        NothingPluggedIn, match=r"with serial number B2 is not plugged in \(plugged"
    ):
        the_one("sdl_stick", (ONE,), "", "B2")

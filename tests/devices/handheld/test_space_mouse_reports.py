"""The bytes of a SpaceMouse."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.handheld.space_mouse_reports import CapState

REST = CapState()


def test_translation_and_rotation_come_in_two_reports() -> None:
    moved = REST.after(bytes.fromhex("01 5e01 a2fe 0000"))
    assert moved.translation == (350.0, -350.0, 0.0)
    turned = moved.after(bytes.fromhex("02 0000 e2ff 0a00"))
    assert turned == CapState((350.0, -350.0, 0.0), (0.0, -30.0, 10.0))


def test_newer_models_tell_all_six_at_once() -> None:
    told = REST.after(bytes.fromhex("01 0100 0200 0300 0400 0500 ffff"))
    assert told == CapState((1.0, 2.0, 3.0), (4.0, 5.0, -1.0))


def test_buttons_batteries_and_scraps_move_nothing() -> None:
    held = CapState((7.0, 0.0, 0.0))
    for report in ("03 01 00", "17 64 00", "01 5e", "02", ""):
        assert held.after(bytes.fromhex(report)) == held


@given(st.binary(max_size=64))
def test_any_bytes_are_borne(report: bytes) -> None:
    state = REST.after(report)
    assert len(state.translation) == len(state.rotation) == 3

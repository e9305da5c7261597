"""Scales of ratings."""

from __future__ import annotations

import pytest
from pydantic import ValidationError

from omnistudy.survey import Anchor, Scale


def anchors(*values: int) -> tuple[Anchor, ...]:
    return tuple(Anchor(value=value, label=f"word {value}") for value in values)


def test_points_are_every_answer() -> None:
    assert Scale(lowest=-2, highest=2, anchors=anchors(-2, 0, 2)).points == (-2, -1, 0, 1, 2)


def test_a_scale_begins_at_one_unless_it_says_otherwise() -> None:
    assert Scale(highest=3, anchors=anchors(1, 3)).points == (1, 2, 3)


@pytest.mark.parametrize(
    ("lowest", "highest", "given", "said"),
    [
        (5, 1, (1, 5), r"lowest \(5\) must be below highest \(1\)"),
        (3, 3, (3,), "must be below"),
        (1, 5, (1, 6), "an anchor stands at 6, but the scale goes from 1 to 5"),
        (1, 5, (1, 5, 5), "two anchors stand at the same value"),
        (1, 5, (1, 3), r"both ends \(1 and 5\) need an anchor"),
        (1, 5, (), "both ends"),
    ],
)
def test_a_scale_that_could_be_misread_is_refused(
    lowest: int, highest: int, given: tuple[int, ...], said: str
) -> None:
    with pytest.raises(ValidationError, match=said):
        Scale(lowest=lowest, highest=highest, anchors=anchors(*given))


def test_an_anchor_has_a_word() -> None:
    with pytest.raises(ValidationError):
        Anchor(value=1, label="")

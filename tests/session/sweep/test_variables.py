from __future__ import annotations

import pytest
from hydra.core.override_parser.overrides_parser import OverridesParser
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.sweep import (
    EmptyInterval,
    NotASweepOverride,
    NothingSwept,
    NoValues,
    RoleOfNoKey,
    SweptTwice,
)
from omnistudy.session.sweep.variables import Interval, override_text, read_words


@pytest.mark.parametrize(
    ("word", "values"),
    [
        ("law.stiffness.x=100,200,300", (100, 200, 300)),
        ("law.stiffness.x=range(100,300,50)", (100, 150, 200, 250)),
        ("law.stiffness.x=range(0,0.4,0.1)", (0.0, 0.1, 0.2, 0.3)),
        ("law=none,component", ("none", "component")),
        ("site.display='a word, and another',none", ("a word, and another", "none")),
        ("law.stiffness.x=choice(5)", (5,)),
        ("law.stiffness.x=shuffle(3,1,2)", (3, 1, 2)),
        ("law.stiffness.x=interval(100,300)", Interval(100.0, 300.0, whole=False)),
        ("recording.physics_hz=int(interval(1,5))", Interval(1, 5, whole=True)),
    ],
)
def test_values_are_read_in_hydras_grammar(word: str, values: object) -> None:
    (swept,) = read_words([word]).swept
    assert swept.values == values
    assert swept.variable.asked == word.partition("=")[2]


def test_words_are_sorted_by_what_they_are_for() -> None:
    asked = read_words(
        ["law.stiffness.x=1,2", "law=component", "~site.display", "hydra.launcher.partition=short"]
    )
    assert [one.variable.key for one in asked.swept] == ["law.stiffness.x"]
    assert asked.overrides == ("law=component", "~site.display")
    assert asked.launcher == ("hydra.launcher.partition=short",)


def test_what_one_meets_is_nuisance_and_what_one_chooses_is_design() -> None:
    words = ["law.stiffness.x=1,2", "operator.skill_median=1,2", "operator.arm.mass=1,2"]
    roles = {
        one.variable.key: one.variable.role
        for one in read_words(words, design=["operator.arm.mass"]).swept
    }
    assert roles == {
        "law.stiffness.x": "design",
        "operator.skill_median": "nuisance",
        "operator.arm.mass": "design",
    }
    (turned,) = read_words(["law.stiffness.x=1,2"], nuisance=["law.stiffness.x"]).swept
    assert turned.variable.role == "nuisance"


@pytest.mark.parametrize(
    ("words", "mistake", "said"),
    [
        (["law.stiffness.x"], NotASweepOverride, "'law.stiffness.x' is no KEY=VALUES"),
        (["law=glob(*)"], NotASweepOverride, "is no KEY=VALUES"),
        (["law.stiffness.x="], NoValues, "law.stiffness.x is given no values"),
        (["law.stiffness.x=range(3,1)"], NoValues, "law.stiffness.x is given no values"),
        (["a=interval(3,1)"], EmptyInterval, r"a=interval\(3,1\) is empty"),
        (["a=1,2", "a=3,4"], SweptTwice, "a is given twice"),
        (["a=1,2", "a=3"], SweptTwice, "a is given twice"),
        (["a=1"], NothingSwept, "no key has more than one value"),
    ],
)
def test_what_cannot_be_read_is_said_in_one_sentence(
    words: list[str], mistake: type[Exception], said: str
) -> None:
    with pytest.raises(mistake, match=said):
        read_words(words)


def test_a_role_of_a_key_that_is_not_swept_names_the_nearest() -> None:
    with pytest.raises(RoleOfNoKey, match=r"did you mean 'law\.stiffness\.x'"):
        read_words(["law.stiffness.x=1,2"], nuisance=["law.stifness.x"])


@given(
    st.one_of(
        st.none(),
        st.booleans(),
        st.integers(-1000, 1000),
        st.floats(allow_nan=False, allow_infinity=False),
        st.text(st.characters(min_codepoint=32, max_codepoint=126), max_size=12),
        st.lists(st.integers(-9, 9), max_size=3),
    )
)
def test_hydra_reads_back_every_value_that_is_written_for_it(value: object) -> None:
    (override,) = OverridesParser.create().parse_overrides([override_text("key", value)])
    assert override.value() == value
    assert type(override.value()) is type(value)

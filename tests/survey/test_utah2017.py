"""The questionnaire of the published study (Tyagi 2017, appendix A)."""

from __future__ import annotations

import pytest

from omnistudy.protocol.compose import compose_protocol
from omnistudy.survey import ChoiceItem, Instrument, LikertItem, TextItem, load_instrument


@pytest.fixture(scope="module")
def survey() -> Instrument:
    return load_instrument("utah2017")


def test_ten_items_and_comments(survey: Instrument) -> None:
    kinds = [item.kind for item in survey.items]
    assert kinds == ["likert"] * 8 + ["choice", "likert", "text"]
    assert isinstance(survey.items[-1], TextItem)
    assert [item.name for item in survey.items if not item.required] == ["comments"]


def test_ratings_go_from_very_poor_to_very_good(survey: Instrument) -> None:
    for item in survey.items:
        if isinstance(item, LikertItem):
            words = {anchor.value: anchor.label for anchor in item.scale.anchors}
            assert words == {1: "very poor", 2: "poor", 3: "average", 4: "good", 5: "very good"}


def test_two_questions_each_about_four_sets_of_trials(survey: Instrument) -> None:
    asked = [(item.name.partition("_")[0], item.conditions) for item in survey.items[:8]]
    pairs = [("full",), ("none",), ("centre_front_10", "centre_front_20"), ("zero_torque",)]
    assert asked == [(what, about) for about in pairs for what in ("avoidance", "comfort")]


def test_the_fourth_answer_to_which_was_best_is_ours(survey: Instrument) -> None:
    best = survey.items[8]
    assert isinstance(best, ChoiceItem)
    assert [option.source for option in best.options] == ["", "", "", "ours"]
    assert best.options[3].conditions == ("centre_front_10", "centre_front_20")


def test_whose_words_these_are_is_said(survey: Instrument) -> None:
    assert "Tyagi 2017" in survey.source
    assert "ours" in survey.source


def test_it_asks_about_conditions_of_the_published_protocol(survey: Instrument) -> None:
    there = {condition.name for condition in compose_protocol("utah2017_component").conditions}
    asked = {name for item in survey.items for name in item.conditions}
    best = survey.items[8]
    assert isinstance(best, ChoiceItem)
    asked |= {name for option in best.options for name in option.conditions}
    assert asked <= there

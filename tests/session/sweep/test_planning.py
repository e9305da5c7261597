from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from small_sweep import ARMS, GAINS, ONE_TRIAL, PROTOCOL, SHORT, question, small_plan

from omnistudy.errors.protocol import UnknownCondition
from omnistudy.errors.sweep import (
    AdaptiveOrder,
    BadSweepName,
    HumanSweep,
    IntervalNeedsSamples,
    KeyChangesNothing,
    NothingToSearch,
    SamplesNeedInterval,
    SearchNeedsSamples,
    TooManyParticipants,
)
from omnistudy.protocol.compose import compose_protocol
from omnistudy.session.sweep.planning import Question, Thinning, plan_sweep, sweep_name
from omnistudy.store import open_study
from omnistudy.study import create_study


def test_every_design_point_meets_every_nuisance_point() -> None:
    sweep = small_plan().sweep
    assert [(one.design, one.nuisance, one.values) for one in sweep.points] == [
        (1, 1, (100, 100)),
        (1, 2, (100, 300)),
        (2, 1, (400, 100)),
        (2, 2, (400, 300)),
    ]


def test_trials_and_seeds_are_those_of_a_study_of_the_base_protocol(tmp_path: Path) -> None:
    """Common random numbers: the very trials that a study would run, the same at every point."""
    create_study(compose_protocol(PROTOCOL, SHORT), tmp_path / "study.db", "study")
    sweep = plan_sweep(question(GAINS, ARMS, thinning=Thinning())).sweep
    with open_study(tmp_path / "study.db") as study:
        stored = study.trials()
    kept = stored[stored["condition"].isin(sweep.conditions)]
    columns = ["participant", "position", "condition", "repetition", "route", "seed"]
    assert [tuple(row) for row in kept[columns].itertuples(index=False)] == [
        (one.participant, one.position, one.condition, one.repetition, one.route, one.seed)
        for one in sweep.trials
    ]


def test_conditions_are_those_that_the_design_keys_change() -> None:
    """The arm changes driving without feedback too, but no gain does."""
    assert "none" not in small_plan().sweep.conditions
    assert "full" in small_plan().sweep.conditions
    arms_alone = plan_sweep(question(ARMS)).sweep
    assert "none" in arms_alone.conditions


def test_thinning_takes_the_first_of_what_the_plan_has() -> None:
    whole = plan_sweep(question(GAINS, thinning=Thinning(("full",)))).sweep
    thin = plan_sweep(question(GAINS, thinning=Thinning(("full",), 1, 2))).sweep
    assert {one.condition for one in whole.trials} == {"full"}
    first = [one for one in whole.trials if one.participant == "P01"]
    assert list(thin.trials) == first[:2]


def test_a_key_with_one_value_holds_for_the_base_too() -> None:
    sweep = plan_sweep(question(GAINS, "law.stiffness.y=50")).sweep
    assert sweep.base["law"]["stiffness"]["y"] == 50
    assert sweep.design_hash != small_plan(GAINS).sweep.design_hash


def test_a_name_is_made_from_what_is_asked() -> None:
    sweep = small_plan().sweep
    made = sweep_name(sweep, None)
    assert made.startswith("utah2017_component_")
    assert made == sweep_name(plan_sweep(question(GAINS, ARMS)).sweep, None)
    assert made != sweep_name(plan_sweep(question(GAINS, ARMS, seed="other")).sweep, None)
    assert sweep_name(sweep, "gains_2") == "gains_2"
    with pytest.raises(BadSweepName, match=r"'\.\./gains' cannot be a sweep's name"):
        sweep_name(sweep, "../gains")


@pytest.mark.parametrize(
    ("words", "rest", "mistake", "said"),
    [
        (
            [GAINS],
            {"thinning": Thinning(("none",))},
            KeyChangesNothing,
            "law.stiffness.x changes nothing in the set-up of the conditions none",
        ),
        (["participants.participant_key=a,b"], {}, KeyChangesNothing, "participant_key changes"),
        ([GAINS], {"thinning": Thinning(("ful",))}, UnknownCondition, "did you mean 'full'"),
        ([GAINS], {"thinning": Thinning(participants=9)}, TooManyParticipants, "plans 2"),
        ([GAINS], {"samples": 4}, SamplesNeedInterval, "no key is an interval"),
        (["law.stiffness.x=interval(1,2)"], {}, IntervalNeedsSamples, "is an interval"),
        ([GAINS], {"objective": "collisions"}, SearchNeedsSamples, "needs --samples"),
        ([ARMS], {"objective": "collisions", "samples": 3}, NothingToSearch, "is a nuisance"),
    ],
)
def test_what_cannot_be_swept_is_said_in_one_sentence(
    words: list[str], rest: dict[str, Any], mistake: type[Exception], said: str
) -> None:
    with pytest.raises(mistake, match=said):
        plan_sweep(question(*words, **rest))


def test_people_are_not_swept() -> None:
    human = (
        "participants={kind: human, count: 2, study_key: '', participant_key: ''}",
        "site.ethics={status: approved, board: B, number: '1', note: ''}",
    )
    words = (GAINS, *human, *(word for word in SHORT if "participants" not in word))
    with pytest.raises(HumanSweep, match="is for human participants"):
        plan_sweep(Question(PROTOCOL, words, thinning=ONE_TRIAL))


def test_an_order_that_adapts_is_refused() -> None:
    published = ("~order.blocks", "~order.block_length", "~order.last")
    staircase = (*published, "order.kind=staircase", "order.count=4", "order.start=none")
    with pytest.raises(AdaptiveOrder, match="chooses conditions while it runs"):
        plan_sweep(question(GAINS, *staircase))

"""What is said of a task before anything moves."""

from __future__ import annotations

import pytest

from omnistudy.arm.check import check_task, looks, start_of
from omnistudy.arm.find import load_task
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import UnknownArm


def page(*goals: dict[str, object]) -> ArmTask:
    motions = [{"name": f"part {n}", "goal": goal} for n, goal in enumerate(goals, start=1)]
    return ArmTask.model_validate({"controller": {"kind": "sri_wln"}, "motions": motions})


def test_one_answer_a_line_and_four_an_arc() -> None:
    task = load_task("door_right")
    told: list[None] = []
    checked = check_task(task, lambda: told.append(None))
    assert [(p.motion, p.share) for p in checked.poses] == [
        ("approach", 1.0),
        ("opening", 0.25),
        ("opening", 0.5),
        ("opening", 0.75),
        ("opening", 1.0),
    ]
    assert len(told) == looks(task) == 5
    assert checked.possible
    assert checked.poses[0].answer.startswith("can be reached with the chair at x ")


def test_a_motion_begins_where_the_one_before_ended() -> None:
    checked = check_task(page({"position": [2.0, 0.5, 0.9]}, {"position": [2.0, 0.5, 0.85]}))
    assert checked.possible
    assert "from where the chair stands" in checked.poses[1].answer


def test_an_answer_says_what_would_be_touched() -> None:
    checked = check_task(page({"position": [1.0, -0.131, 0.05]}))
    assert checked.possible
    assert "with the arm in zone floor" in checked.poses[0].answer


def test_an_answer_says_how_much_is_missing() -> None:
    checked = check_task(page({"position": [1.0, 0.0, 3.0]}))
    assert not checked.possible
    assert "the hand is still" in checked.poses[0].answer


def test_a_task_starts_as_its_page_says() -> None:
    start = start_of(load_task("reach"))
    assert start.hand[:3, 3] == pytest.approx((0.586, -0.131, 0.899))


def test_an_arm_that_is_not_there() -> None:
    task = page({}).model_copy(update={"arm": "wmra3"})
    with pytest.raises(UnknownArm, match=r"no arm 'wmra3'.*did you mean 'wmra"):
        start_of(task)

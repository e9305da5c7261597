"""Tasks of an arm planned before they move, then led: the ordinary ones and the awkward ones."""

from __future__ import annotations

from math import degrees, pi
from typing import Any

import numpy as np
import pytest

from omnistudy.arm.find import load_task
from omnistudy.arm.run import ArmRun, MotionSummary, summaries
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import ImpossibleStart, ImpossibleTask
from omnistudy.registry import load_kind
from omnistudy.session.plan_arm import is_led, look_for_plan, plan_task
from omnistudy.session.solve_arm import solve_task

READY = (pi / 2, pi / 2, 0.0, pi / 2, pi / 2, pi / 2, 0.0)
STRETCHED = (pi / 2, pi / 2, 0.0, 0.0, 0.0, 0.0, 0.0)
LIMIT_6 = 100 * pi / 180


def task(
    goal: dict[str, Any],
    *,
    joints: tuple[float, ...] | str = READY,
    controller: dict[str, Any] | None = None,
    **motion: Any,
) -> ArmTask:
    """A task with one motion, led with all zones on."""
    return ArmTask.model_validate(
        {
            "start": {"joints": joints},
            "controller": controller or {"kind": "dual_qp"},
            "motions": [{"name": "it", "goal": goal, **motion}],
        }
    )


def led(name: str) -> ArmTask:
    """One of our pages with `dual_qp` for all its motions, and no goal for the chair."""
    page = load_task(name)
    free = {"controller": None, "chair_goal": None}
    motions = tuple(motion.model_copy(update=free) for motion in page.motions)
    controller = load_kind("controllers", "dual_qp")()
    return page.model_copy(update={"controller": controller, "motions": motions})


def run(page: ArmTask) -> tuple[ArmRun, MotionSummary]:
    done = solve_task(page)
    keeps_its_limits(done)
    return done, summaries(done)[-1]


def keeps_its_limits(done: ArmRun) -> None:
    from omnistudy.arm import ArmBody, load_arm

    body = ArmBody(load_arm(done.arm))
    for before, after in zip(done.steps, done.steps[1:], strict=False):
        joints = np.array(after.joints)
        assert ((joints > body.lower - 1e-6) & (joints < body.upper + 1e-6)).all()
        dt = after.t - before.t
        rates = np.abs(joints - np.array(before.joints)) / dt
        assert (rates <= body.top_rates[:7] + 1e-4).all()
        assert not body.zones.intrusions(body.frames(joints)).names


def arrived(summary: MotionSummary) -> bool:
    return summary.final_error < 1e-5 and degrees(summary.final_turn) < 1e-3


def test_only_controllers_that_lead_the_chair_are_planned_for() -> None:
    assert is_led(task({}))
    assert not is_led(load_task("reach"))


def test_hand_and_chair_arrive_together_where_the_published_weights_leave_the_chair_behind() -> (
    None
):
    page = load_task("reach")
    dual = page.model_copy(update={"controller": load_kind("controllers", "dual_qp")()})
    _, summary = run(dual)
    assert arrived(summary)
    assert summary.worst_error < 1e-4
    assert summary.chair_error < 1e-4
    assert degrees(summary.chair_turn) < 0.01


def test_a_path_that_leads_nowhere_is_one_step() -> None:
    _, summary = run(task({}))
    assert (summary.steps, summary.driven) == (1, 0.0)
    assert arrived(summary)


def test_a_turn_without_a_way_takes_its_own_time() -> None:
    _, summary = run(task({"turns": [{"axis": "z", "angle": pi / 2}]}))
    # a quarter turn at 0.15 rad/s
    assert summary.duration == pytest.approx(10.47, abs=0.2)
    assert arrived(summary)


def test_half_a_turn() -> None:
    _, summary = run(task({"turns": [{"axis": "z", "angle": pi}]}))
    assert arrived(summary)


@pytest.mark.slow
def test_half_a_turn_that_no_posture_makes_over_the_ground_is_made_in_free_space() -> None:
    goal = {"turns": [{"axis": "x", "angle": pi}]}
    with pytest.raises(ImpossibleTask, match="stops after"):
        plan_task(task(goal))
    _, summary = run(task(goal, carried=True))
    assert arrived(summary)


@pytest.mark.parametrize("carried", [True, False])
def test_a_stretched_arm_bends_and_goes(carried: bool) -> None:
    page = task({"position": [0.5, 0.5, 0.9]}, joints=STRETCHED, carried=carried)
    done, summary = run(page)
    assert done.steps[0].arm_manipulability < 1e-3
    assert arrived(summary)
    assert summary.worst_error < 1e-3


@pytest.mark.parametrize("carried", [True, False])
def test_a_joint_at_its_limit_turns_back(carried: bool) -> None:
    joints = (*READY[:5], LIMIT_6, 0.0)
    _, summary = run(task({"position": [0.8, -0.1, 0.9]}, joints=joints, carried=carried))
    assert arrived(summary)


def test_a_start_beyond_a_limit_is_refused() -> None:
    with pytest.raises(ImpossibleStart, match="joint 4"):
        plan_task(task({}, joints="park"))


def test_the_chair_backs_up_instead_of_turning_round() -> None:
    _, summary = run(task({"position": [-0.4, -0.131, 0.899]}, chair_goal={"x": -0.986}))
    assert summary.driven == pytest.approx(-0.986, abs=1e-3)
    assert arrived(summary)


def test_position_alone() -> None:
    law = {"kind": "dual_qp", "follows": "position"}
    _, summary = run(task({"position": [0.6, 0.0, 1.0]}, controller=law))
    assert summary.final_error < 1e-5


def test_a_goal_out_of_reach_is_refused_with_how_much_is_short() -> None:
    with pytest.raises(
        ImpossibleTask, match=r"motion 'it' is refused .* the hand is still 1\d{3} mm"
    ):
        plan_task(task({"position": [1.0, 0.0, 3.0]}))
    assert look_for_plan(task({"position": [1.0, 0.0, 3.0]})).tries == 0


def test_a_goal_too_far_from_the_chairs_is_refused_with_the_nearest_stand_off() -> None:
    page = task({"position": [3.0, 0.0, 0.9]}, chair_goal={"x": 1.0}, carried=True)
    plan = look_for_plan(page)
    assert plan.motions == ()
    assert plan.refused is not None
    assert (plan.refused.motion, plan.refused.possible) == ("it", False)
    why = plan.refused.answer
    assert "with the chair at its goal, x 1.00 m, y 0.00 m, heading 0 deg" in why
    # the hand of a stretched arm is at most 1.34 m from the arm's base
    where = why[why.rindex("with the chair at x") :]
    assert 3.0 - 1.34 < float(where.split()[5]) < 3.0


@pytest.mark.slow
def test_without_a_goal_the_chair_goes_to_a_stand_off() -> None:
    page = task({"position": [3.0, 1.0, 0.9]}, carried=True)
    plan = plan_task(page)
    (planned,) = plan.motions
    assert planned.end is not None
    assert planned.answer.answer.startswith("carried by the chair, to x ")
    done, summary = run(page)
    assert arrived(summary)
    assert done.steps[-1].chair == pytest.approx(planned.end.chair, abs=1e-9)


def test_a_published_motion_may_stand_between_planned_ones() -> None:
    page = ArmTask.model_validate(
        {
            "controller": {"kind": "dual_qp"},
            "motions": [
                {"name": "to", "carried": True, "goal": {"position": [1.2, 0.1, 0.9]}},
                {
                    "name": "in",
                    "goal": {"frame": "gripper", "position": [0, 0, 0.05]},
                    "controller": {"kind": "sri_wln", "zones": "none"},
                },
                {"name": "out", "goal": {"frame": "gripper", "position": [0, 0, -0.05]}},
            ],
        }
    )
    found = summaries(solve_task(page))
    assert [summary.motion for summary in found] == ["to", "in", "out"]
    assert all(summary.followed for summary in found)


def test_the_same_task_has_the_same_steps() -> None:
    page = task({"position": [0.8, 0.2, 0.9]}, carried=True)
    assert solve_task(page) == solve_task(page)


@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["door_right", "door_right_following", "door_left", "door_left_following"]
)
def test_both_doors_are_opened_from_where_the_search_puts_the_chair(name: str) -> None:
    page = led(name)
    done = solve_task(page)
    keeps_its_limits(done)
    approach, opening = summaries(done)
    assert arrived(approach)
    assert arrived(opening)
    # the hand holds the handle all the way
    assert opening.worst_error < 2e-4
    assert degrees(opening.worst_turn) < 0.02


@pytest.mark.slow
def test_the_book_is_taken() -> None:
    done = solve_task(led("book"))
    keeps_its_limits(done)
    assert all(arrived(summary) for summary in summaries(done))

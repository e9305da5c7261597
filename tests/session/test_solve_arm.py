"""Tasks of an arm, run to their end: the ordinary ones and the awkward ones."""

from __future__ import annotations

from collections import Counter
from math import isnan, pi, radians
from typing import Any

import numpy as np
import pytest

from omnistudy.arm.run import ArmRun, MotionSummary, summaries
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import (
    ImpossibleStart,
    ImpossibleTask,
    NotAnArmController,
    TooManySteps,
)
from omnistudy.session.plan_arm import arm_controllers
from omnistudy.session.solve_arm import refuse_impossible, solve_task

KINDS = ("sri_wln", "pi_wln", "sri_ene", "pi_ene")
READY = (pi / 2, pi / 2, 0.0, pi / 2, pi / 2, pi / 2, 0.0)


def task(
    goal: dict[str, Any],
    kind: str = "sri_wln",
    *,
    joints: tuple[float, ...] = READY,
    **motion: Any,
) -> ArmTask:
    """A task with one motion and a controller without zones."""
    return ArmTask.model_validate(
        {
            "start": {"joints": joints},
            "controller": {"kind": kind, "zones": "none"},
            "motions": [{"name": "it", "goal": goal, **motion}],
        }
    )


def run(page: ArmTask) -> tuple[ArmRun, MotionSummary]:
    done = solve_task(page)
    assert all(np.isfinite(step.joints).all() for step in done.steps)
    (summary,) = summaries(done)
    return done, summary


def hits(done: ArmRun) -> set[str]:
    return {hit for step in done.steps for hit in step.hits}


@pytest.mark.parametrize("kind", KINDS)
def test_a_path_that_leads_nowhere_is_one_step(kind: str) -> None:
    done, summary = run(task({}, kind))
    assert (summary.steps, summary.duration) == (1, 0.0)
    assert summary.final_error < 1e-4
    assert isnan(done.steps[0].bearing)


@pytest.mark.parametrize("kind", KINDS)
def test_a_turn_without_a_way_takes_its_own_time(kind: str) -> None:
    done, summary = run(task({"turns": [{"axis": "z", "angle": pi / 2}]}, kind))
    # a quarter turn at 0.15 rad/s
    assert summary.duration == pytest.approx(10.47, abs=0.05)
    assert summary.followed
    assert summary.worst_error < 1e-4
    assert done.steps[-1].hand == pytest.approx((0.586, -0.131, 0.899), abs=1e-5)


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_half_a_turn_about_any_axis(kind: str, axis: str) -> None:
    _, summary = run(task({"turns": [{"axis": axis, "angle": pi}]}, kind))
    assert summary.followed


def test_half_a_turn_at_once_is_seen_by_the_logarithm_and_not_by_the_published_error() -> None:
    goal = {"turns": [{"axis": "z", "angle": pi}]}
    # steps of a second and a turn within one of them: the second step is asked for all of it
    page = task(goal, turning=pi, pace="hand", timing={"law": "linear"})
    page = page.model_copy(update={"step": 1.0})
    _, mended = run(page)
    assert mended.final_turn < pi - 0.4
    _, published = run(page.model_copy(update={"error": "legacy"}))
    assert published.final_turn == pytest.approx(pi, abs=1e-6)


@pytest.mark.parametrize(
    ("kind", "moves"), [("sri_wln", True), ("sri_ene", True), ("pi_wln", False), ("pi_ene", False)]
)
def test_a_singular_start(kind: str, moves: bool) -> None:
    # stretched straight sideways; the pseudo-inverse has no answer and stands still
    page = task({"frame": "gripper", "position": [0, 0, -0.2]}, kind, joints=(0.0,) * 7)
    done, summary = run(page)
    assert summary.followed == moves
    if not moves:
        assert hits(done) == {"singular"}
        assert done.steps[-1].joints == (0.0,) * 7


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_joint_that_starts_at_its_limit(kind: str, side: float) -> None:
    joints = (*READY[:6], side * radians(200))
    turns = [{"axis": "z", "angle": side * pi / 2}]
    page = task({"frame": "gripper", "turns": turns}, kind, joints=joints)
    done, summary = run(page)
    assert summary.followed
    assert max(abs(step.joints[6]) for step in done.steps) <= radians(200) + 1e-9


@pytest.mark.parametrize("kind", KINDS)
def test_no_joint_ever_passes_its_limit_nor_its_speed(kind: str) -> None:
    # out of reach in height: the arm is driven against everything it has
    done, summary = run(task({"position": [1.0, -0.131, 1.8]}, kind, pace="hand"))
    assert not summary.followed
    joints = np.array([step.joints for step in done.steps])
    assert (np.abs(joints) <= np.radians([170] * 5 + [100, 200]) + 1e-9).all()
    rates = np.diff(joints, axis=0) / np.diff([step.t for step in done.steps])[:, None]
    assert np.abs(rates).max() <= 0.5 + 1e-6


def test_what_cannot_be_reached_is_refused_with_the_reason_and_the_nearest_place() -> None:
    page = task({"position": [1.455, 1.169, 3.0]})
    with pytest.raises(ImpossibleTask) as refused:
        refuse_impossible(page)
    said = str(refused.value)
    assert said.startswith("motion 'it' is refused before anything moves: no chair pose was found")
    assert "heading" in said
    assert "mm and" in said
    assert "--unchecked" in said


def test_what_can_be_reached_is_not_refused() -> None:
    refuse_impossible(task({"position": [1.455, 1.169, 0.999]}))


@pytest.mark.parametrize(
    ("joints", "fault"),
    [
        ("park", "joint 4 is at 3.1416 rad, and its limits are -2.9671 and 2.9671 rad"),
        ((0.0,) * 6, "6 angles are given, 'wmra1' has 7"),
    ],
)
def test_a_start_where_the_arm_cannot_be(joints: Any, fault: str) -> None:
    with pytest.raises(ImpossibleStart, match=fault):
        solve_task(task({}, joints=joints))


def test_motions_follow_each_other_where_the_last_one_ended() -> None:
    page = task({"frame": "gripper", "position": [0, 0, 0.1]})
    back = page.motions[0].model_copy(
        update={"name": "back", "goal": {"frame": "gripper", "position": [0, 0, -0.1]}}
    )
    done = solve_task(page.model_copy(update={"motions": (*page.motions, back)}))
    assert Counter(step.motion for step in done.steps) == {"it": 41, "back": 41}
    assert done.steps[-1].hand == pytest.approx((0.586, -0.131, 0.899), abs=1e-5)
    times = np.diff([step.t for step in done.steps])
    assert times == pytest.approx(0.05)


def test_the_wheelchairs_frame_goes_with_the_chair() -> None:
    page = task({"frame": "wheelchair", "position": [0.7, 0.0, 0.6]})
    turned = page.model_copy(
        update={"start": {"joints": READY, "chair": {"x": 1.0, "y": 2.0, "theta": pi / 2}}}
    )
    done, summary = run(turned)
    assert summary.followed
    # 0.7 m ahead of a base at (1, 2) that looks along y, 0.6 m above its 0.35 m
    assert done.steps[-1].hand == pytest.approx((1.0, 2.7, 0.95), abs=1e-4)


def test_a_chair_with_a_goal_is_measured_against_its_own_route() -> None:
    page = task({"position": [1.086, -0.131, 0.899]}, chair_goal={"x": 0.5})
    done, summary = run(page)
    first, last = done.steps[0], done.steps[-1]
    assert first.wanted_chair == pytest.approx((0.0, 0.0, 0.0))
    assert last.wanted_chair == pytest.approx((0.5, 0.0, 0.0))
    assert summary.chair_error == last.chair_error > 0.1


def test_a_motion_takes_longer_where_joints_could_not_follow() -> None:
    hand, everything = (
        run(task({"position": [0.586, -0.131, 0.999]}, speed=1.0, pace=pace))[1]
        for pace in ("hand", "all")
    )
    assert hand.duration == pytest.approx(0.1)
    assert hand.held_back > 0
    assert everything.duration > 2.0 * hand.duration
    # an estimate: the least that any controller needs, not what this one takes
    assert everything.worst_error < 0.1 * hand.worst_error
    assert everything.followed


@pytest.mark.parametrize("kind", KINDS)
def test_the_same_task_gives_the_same_numbers(kind: str) -> None:
    page = task({"position": [0.7, 0.0, 0.8]}, kind)
    assert solve_task(page) == solve_task(page)


def test_the_three_stages_do_not_bring_the_chair_to_its_goal() -> None:
    page = ArmTask.model_validate(
        {
            "controller": {
                "kind": "sri_wln",
                "zones": "none",
                "chair_weights": {"kind": "staged"},
            },
            "motions": [
                {
                    "name": "reach",
                    "goal": {
                        "position": [1.455, 1.169, 0.999],
                        "rotation": [[0, 0, 1], [-1, 0, 0], [0, -1, 0]],
                    },
                    "chair_goal": {"x": 0.869, "y": 1.3},
                }
            ],
        }
    )
    _, summary = run(page)
    assert summary.chair_error > 0.3


def test_a_motion_that_would_never_end_is_refused() -> None:
    page = task({"frame": "gripper", "position": [0, 0, 0.1]}, speed=1e-6, pace="hand")
    with pytest.raises(TooManySteps, match="motion 'it' would take 100000 s, which is 2000000"):
        solve_task(page)


def test_a_controller_of_the_floor_leads_no_arm() -> None:
    page = task({}).model_copy(update={"controller": {"kind": "rate"}})
    with pytest.raises(
        NotAnArmController, match="'rate' leads no arm: those that do are dual_qp, pi_ene"
    ):
        solve_task(page)
    assert {*KINDS} <= {*arm_controllers()}
    assert "rate" not in arm_controllers()


def test_progress_adds_up_to_the_motions() -> None:
    told: list[float] = []
    page = task({"frame": "gripper", "position": [0, 0, 0.05]})
    solve_task(page, told.append)
    assert sum(told) == pytest.approx(1.0)

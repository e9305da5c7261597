"""Pages of arms and tasks, and what is said when they are wrong."""

from __future__ import annotations

from math import pi
from pathlib import Path

import numpy as np
import pytest
from pydantic import ValidationError

from omnistudy.arm.find import arm_names, load_arm, load_task
from omnistudy.arm.paths import ArcPath, LinePath
from omnistudy.arm.task import ArmTask, Motion
from omnistudy.controllers.sri_wln import SriWln
from omnistudy.errors.arm import BrokenArmPage, UnknownArmTask
from omnistudy.geometry.rigid_motion import rotation, transform

WMRA1 = Path(__file__).parents[2] / "conf" / "arm" / "wmra1.yaml"
HAND = transform(rotation(np.array((0.0, 0.0, 1.0)), pi / 2), np.array((1.0, 2.0, 0.9)))
BASE = transform(np.eye(3), np.array((0.5, 0.0, 0.35)))

PAGE = """
controller: {kind: sri_wln, damping: legacy, chair_weights: {kind: fixed, drive: 2}}
motions:
  - name: there
    goal: {position: [1, 0, 1]}
"""


def write(tmp_path: Path, text: str) -> str:
    file = tmp_path / "task.yaml"
    file.write_text(text, encoding="utf-8")
    return str(file)


def motion(**parts: object) -> Motion:
    return Motion.model_validate({"name": "it", **parts})


def test_a_page_becomes_a_task(tmp_path: Path) -> None:
    task = load_task(write(tmp_path, PAGE))
    assert isinstance(task.controller, SriWln)
    assert task.controller.damping == "legacy"
    assert task.controller.chair_weights.drive == 2.0
    assert task.start.joints == "ready"


@pytest.mark.parametrize(
    ("frame", "place"),
    [("ground", (0.1, 0.2, 0.3)), ("wheelchair", (0.6, 0.2, 0.65)), ("gripper", (0.8, 2.1, 1.2))],
)
def test_goals_in_each_frame(frame: str, place: tuple[float, float, float]) -> None:
    path = motion(goal={"frame": frame, "position": [0.1, 0.2, 0.3]}).path(HAND, BASE)
    assert path.pose(1.0)[:3, 3] == pytest.approx(place)
    assert path.pose(1.0)[:3, :3] == pytest.approx(HAND[:3, :3])


def test_a_rotation_is_seen_from_its_frame() -> None:
    same = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    seen = {
        frame: motion(goal={"frame": frame, "rotation": same}).path(HAND, BASE).pose(1.0)
        for frame in ("ground", "gripper")
    }
    assert seen["ground"][:3, :3] == pytest.approx(np.eye(3))
    assert seen["gripper"] == pytest.approx(HAND)


def test_turns_are_about_the_hands_own_axes() -> None:
    path = motion(goal={"turns": [{"axis": "x", "angle": pi / 2}]}).path(HAND, BASE)
    assert path.pose(1.0)[:3, 3] == pytest.approx(HAND[:3, 3])
    assert path.pose(1.0)[:3, 0] == pytest.approx(HAND[:3, 0])
    assert path.pose(1.0)[:3, 1] == pytest.approx((0.0, 0.0, 1.0))


def test_a_hinge_makes_an_arc_from_where_the_hand_is() -> None:
    made = motion(hinge={"from_hand": [0, -1, 0], "axis": [0, 0, 2], "angle": 1.0})
    path = made.path(HAND, BASE)
    assert isinstance(path, ArcPath)
    assert path.hinge == pytest.approx((1.0, 1.0, 0.9))
    assert path.axis == pytest.approx((0.0, 0.0, 1.0))
    assert isinstance(motion(goal={}).path(HAND, BASE), LinePath)


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        (("goal: {position: [1, 0, 1]}", ""), "motions.there.hinge: .*either a goal or a hinge"),
        (("position: [1, 0, 1]", "positon: [1, 0, 1]"), "positon: unknown key.*mean 'position'"),
        (("[1, 0, 1]", "[1, 0, .nan]"), "position"),
        (("sri_wln", "sri_wlm"), "unknown kind 'sri_wlm'.*did you mean 'sri_wln'"),
        (("damping: legacy", "damping: strong"), "damping: given 'strong'.*'legacy' or 'scaled'"),
        (("[1, 0, 1]", "['1 m', 0, 1]"), "a plain number in m is needed"),
        (("motions:", "speed: 3\nmotions:"), "speed: unknown key"),
        (("motions:", "step: 0\nmotions:"), "step: given 0"),
        (("controller:", "controller"), "not readable as YAML|mapping"),
    ],
)
def test_a_mistake_is_one_clear_sentence(
    tmp_path: Path, change: tuple[str, str], sentence: str
) -> None:
    file = write(tmp_path, PAGE.replace(*change))
    with pytest.raises(BrokenArmPage, match=sentence) as broken:
        load_task(file)
    assert file in str(broken.value)


@pytest.mark.parametrize(
    "rows",
    [
        [[1, 0, 0], [0, 1, 0], [0, 0, -1]],  # left handed
        [[2, 0, 0], [0, 1, 0], [0, 0, 1]],
        [[0, 0, 0], [0, 0, 0], [0, 0, 0]],
    ],
)
def test_a_matrix_that_is_no_rotation(rows: list[list[float]]) -> None:
    with pytest.raises(ValidationError, match="the rows must make a rotation"):
        motion(goal={"rotation": rows})


def test_a_hinge_needs_an_axis() -> None:
    with pytest.raises(ValidationError, match="an axis needs a direction"):
        motion(hinge={"from_hand": [0, 1, 0], "axis": [0, 0, 0], "angle": 1.0})


def test_both_a_goal_and_a_hinge_are_too_much() -> None:
    with pytest.raises(ValidationError, match="either a goal or a hinge"):
        motion(goal={}, hinge={"from_hand": [0, 1, 0], "angle": 1.0})


def test_a_task_that_is_not_there() -> None:
    with pytest.raises(UnknownArmTask, match=r"no arm task 'door_rihgt'.*mean 'door_right"):
        load_task("door_rihgt")


def test_the_labs_folder_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    text = WMRA1.read_text(encoding="utf-8")
    (tmp_path / "arm").mkdir()
    (tmp_path / "arm" / "ours.yaml").write_text(text.replace("name: wmra1", "name: ours"))
    monkeypatch.setenv("OMNISTUDY_CONF", str(tmp_path))
    assert arm_names() == ("ours", "wmra1", "wmra1_vr", "wmra2")
    assert load_arm("ours").name == "ours"


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"ready": (0.0,) * 6}, "ready has 6 angles, but there are 7 joints"),
        (
            {"zones": ({"name": "odd", "guards": "self", "joint": 8},)},
            "zone 'odd' names a joint that the arm does not have",
        ),
        (
            {"joints": ({"alpha": 0, "d": 1, "lower": 1, "upper": 1},) * 7},
            "lower 1 rad is not below upper 1 rad",
        ),
    ],
)
def test_a_profile_that_contradicts_itself(change: dict[str, object], sentence: str) -> None:
    with pytest.raises(ValidationError, match=sentence):
        load_arm("wmra1").model_copy(update=change)


def test_a_task_is_a_value() -> None:
    assert ArmTask.model_validate(load_task("reach").model_dump()) == load_task("reach")

"""Every key of an arm's and a task's page, and every column of a run, is explained."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from pydantic import BaseModel

from omnistudy.arm.profile import ArmProfile, Chair, Joint
from omnistudy.arm.run_file import AFTER_JOINTS, BEFORE_JOINTS
from omnistudy.arm.task import ArmStart, ArmTask, ChairPose, Goal, Hinge, Motion, Turn
from omnistudy.arm.timing import Timing
from omnistudy.arm.zones import Zone
from omnistudy.controllers.dual_qp import DualQp
from omnistudy.registry import kinds

PAGE = (Path(__file__).parents[2] / "docs" / "arm.md").read_text(encoding="utf-8")
MODELS = (
    *(ArmTask, ArmStart, ChairPose, Motion, Goal, Turn, Hinge, Timing),
    *(ArmProfile, Joint, Chair, Zone),
)


@pytest.mark.parametrize("model", MODELS, ids=lambda model: model.__name__)
def test_every_key_is_on_the_page(model: type[BaseModel]) -> None:
    missing = [key for key in model.model_fields if not re.search(rf"\b{key}\b", PAGE)]
    assert missing == []


def test_every_column_is_on_the_page() -> None:
    table = PAGE[PAGE.index("## What a run holds") :]
    spans = {"hand_y", "hand_qy", "hand_qz", "wanted_y", "wanted_chair_y"}
    missing = [name for name in (*BEFORE_JOINTS, *AFTER_JOINTS) if f"`{name}`" not in table]
    assert set(missing) <= spans


def test_every_parameter_of_the_controller_that_leads_is_on_the_page() -> None:
    section = PAGE[PAGE.index("## Hand and chair led together") :]
    assert [key for key in DualQp.model_fields if f"`{key}`" not in section] == ["kind"]


def test_every_arm_controller_is_on_the_page() -> None:
    of_arms = [kind for kind in kinds("controllers") if kind.endswith(("_wln", "_ene", "_qp"))]
    assert len(of_arms) == 5
    assert all(f"`{kind}`" in PAGE for kind in of_arms)

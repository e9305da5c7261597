"""From the name or file of an arm or a task to what stands on its page."""

from __future__ import annotations

from pathlib import Path
from typing import TypeVar

from pydantic import ValidationError

from omnistudy.arm.profile import ArmProfile
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import BrokenArmPage, UnknownArm, UnknownArmTask
from omnistudy.registry import Model
from omnistudy.registry.faults import explain
from omnistudy.registry.pages import page_content, page_file, page_names

Page = TypeVar("Page", bound=Model)


def arm_names() -> tuple[str, ...]:
    """Name every arm in the lab's folder and in ours."""
    return page_names("arm")


def load_arm(name_or_file: str) -> ArmProfile:
    """Read an arm's profile; raises UnknownArm or BrokenArmPage."""
    page = page_file("arm", name_or_file)
    if page is None:
        raise UnknownArm(name_or_file, arm_names())
    return read_page(page, ArmProfile)


def task_names() -> tuple[str, ...]:
    """Name every arm task in the lab's folder and in ours."""
    return page_names("arm_task")


def load_task(name_or_file: str) -> ArmTask:
    """Read a task; raises UnknownArmTask or BrokenArmPage."""
    page = page_file("arm_task", name_or_file)
    if page is None:
        raise UnknownArmTask(name_or_file, task_names())
    return read_page(page, ArmTask)


def read_page(page: Path, model: type[Page]) -> Page:
    """Read a page as a model; raises BrokenArmPage with one sentence a fault."""
    data = page_content(page, BrokenArmPage)
    try:
        return model.model_validate(data)
    except ValidationError as faults:
        raise BrokenArmPage(page, explain(faults, model, data, str(page))) from faults

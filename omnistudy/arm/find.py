"""From the name or file of an arm or a task to what stands on its page."""

from __future__ import annotations

from pathlib import Path
from typing import Any, TypeVar

import yaml
from pydantic import ValidationError

from omnistudy.arm.profile import ArmProfile
from omnistudy.arm.task import ArmTask
from omnistudy.errors.arm import BrokenArmPage, UnknownArm, UnknownArmTask
from omnistudy.registry import Model
from omnistudy.registry.conf import conf_roots
from omnistudy.registry.faults import explain

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


def page_names(group: str) -> tuple[str, ...]:
    """Name the pages of a configuration group."""
    pages = (page for root in conf_roots() for page in (root / group).glob("*.yaml"))
    return tuple(sorted({page.stem for page in pages}))


def page_file(group: str, name_or_file: str) -> Path | None:
    """Give a page: a file that exists, else a name in a group, the lab's folder first."""
    if Path(name_or_file).is_file():
        return Path(name_or_file)
    pages = (root / group / f"{name_or_file}.yaml" for root in conf_roots())
    return next((page for page in pages if page.is_file()), None)


def read_page(page: Path, model: type[Page]) -> Page:
    """Read a page as a model; raises BrokenArmPage with one sentence a fault."""
    data = _parsed(page)
    try:
        return model.model_validate(data)
    except ValidationError as faults:
        raise BrokenArmPage(page, explain(faults, model, data, str(page))) from faults


def _parsed(page: Path) -> Any:
    try:
        return yaml.safe_load(page.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as cause:
        mark = getattr(cause, "problem_mark", None)
        line = f", line {mark.line + 1}" if mark else ""
        problem = getattr(cause, "problem", None) or str(cause).splitlines()[0]
        raise BrokenArmPage(page, (f"{page}{line}: not readable as YAML ({problem})",)) from cause

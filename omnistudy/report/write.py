"""A report of a study file, written as a page."""

from __future__ import annotations

import os
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path

from omnistudy.analysis.report import Report, analyse
from omnistudy.errors.analysis import NoFolderForReport, NotAReport
from omnistudy.report.page import GENERATOR, render
from omnistudy.report.source import study_tables
from omnistudy.store.study_file import open_study
from omnistudy.worlds import World

MARK = f'name="generator" content="{GENERATOR}'
HEAD = 4096
"""Bytes in which a page of ours shows its mark."""
STEPS = 2
"""Steps of `write_report` that take time."""


def analyse_study(study: Path, arm_study: Path | None = None) -> tuple[Report, World | None]:
    """Read a study (and the arm-stiffness study) and compute its report.

    Raises what `omnistudy.open` raises, MixedKinds, NotAnArmStudy.
    """
    with ExitStack() as opened:
        tables = study_tables(opened.enter_context(open_study(study)))
        arms = study_tables(opened.enter_context(open_study(arm_study))) if arm_study else None
        return analyse(tables, arms), tables.world


def write_report(
    study: Path,
    page: Path,
    arm_study: Path | None = None,
    *,
    done: Callable[[], object] = lambda: None,
) -> Report:
    """Write the page of a study; an older report there is replaced, anything else is refused.

    `done` is called after each of STEPS steps: the numbers, the pictures.
    Raises NoFolderForReport, NotAReport, and what `analyse_study` raises; then nothing is written.
    """
    _refuse_other_files(page)
    report, world = analyse_study(study, arm_study)
    done()
    text = render(report, world)
    done()
    draft = page.with_name(f".{page.name}.{os.getpid()}.part")
    try:
        draft.write_text(text, encoding="utf-8")
        draft.replace(page)
    finally:
        draft.unlink(missing_ok=True)
    return report


def _refuse_other_files(page: Path) -> None:
    if not page.parent.is_dir():
        raise NoFolderForReport(page)
    if not page.exists():
        return
    if page.is_dir():
        raise NotAReport(page)
    with page.open("rb") as file:
        head = file.read(HEAD)
    if MARK.encode() not in head:
        raise NotAReport(page)

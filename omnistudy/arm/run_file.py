"""A run of an arm as a CSV file: one row a step."""

from __future__ import annotations

import csv
from io import StringIO
from math import isnan
from pathlib import Path

from omnistudy.arm.run import ArmRun, ArmStep
from omnistudy.errors.arm import BrokenRun, RunExists, RunNotWritten
from omnistudy.geometry import PlanarPose

BEFORE_JOINTS = ("arm", "motion", "step", "t")
AFTER_JOINTS = (
    *("chair_x", "chair_y", "chair_theta"),
    *("hand_x", "hand_y", "hand_z", "hand_qx", "hand_qy", "hand_qz", "hand_qw"),
    *("wanted_x", "wanted_y", "wanted_z", "error", "error_turn"),
    *("wanted_chair_x", "wanted_chair_y", "wanted_chair_theta", "chair_error", "chair_turn"),
    *("driven", "bearing", "manipulability", "arm_manipulability", "smallest"),
    *("damping", "hits"),
)
"""Columns round `q1`, `q2`, ...; SI units, meanings in `ArmStep`. What is not there is empty."""

BETWEEN_HITS = ";"


def write_run(run: ArmRun, file: Path, *, replace: bool = False) -> None:
    """Write a run; numbers with all their digits.

    Raises RunExists unless `replace`, or RunNotWritten.
    """
    table = StringIO()
    writer = csv.writer(table, lineterminator="\n")
    joints = len(run.steps[0].joints)
    writer.writerow((*BEFORE_JOINTS, *(f"q{n}" for n in range(1, joints + 1)), *AFTER_JOINTS))
    writer.writerows(_row(run.arm, step) for step in run.steps)
    write_text(file, table.getvalue(), replace=replace)


def write_text(file: Path, text: str, *, replace: bool) -> None:
    """Write a file whole or not at all; raises RunExists unless `replace`, or RunNotWritten."""
    may_write(file, replace=replace)
    draft = file.with_name(f".{file.name}.part")
    try:
        draft.write_text(text, encoding="utf-8")
        draft.replace(file)
    except OSError as refused:
        raise RunNotWritten(file, refused.strerror or str(refused)) from refused


def may_write(file: Path, *, replace: bool) -> None:
    """Raise RunExists for a file that is there already, unless `replace`."""
    if file.exists() and not replace:
        raise RunExists(file)


def _row(arm: str, step: ArmStep) -> tuple[object, ...]:
    return (
        *(arm, step.motion, step.step, repr(step.t)),
        *map(repr, step.joints),
        *map(repr, (*step.chair, *step.hand, *step.hand_quaternion, *step.wanted)),
        *(repr(step.error), repr(step.error_turn)),
        *(map(repr, step.wanted_chair) if step.wanted_chair else ("", "", "")),
        *(_or_empty(step.chair_error), _or_empty(step.chair_turn)),
        *(repr(step.driven), _or_empty(step.bearing)),
        *(repr(step.manipulability), repr(step.arm_manipulability), repr(step.smallest)),
        *(repr(step.damping), BETWEEN_HITS.join(step.hits)),
    )


def _or_empty(number: float) -> str:
    return "" if isnan(number) else repr(number)


def read_run(file: Path) -> ArmRun:
    """Read a run back; raises BrokenRun."""
    try:
        with file.open(encoding="utf-8", newline="") as opened:
            rows = list(csv.DictReader(opened))
    except FileNotFoundError:
        raise BrokenRun(file, "there is no such file") from None
    except (OSError, UnicodeDecodeError, csv.Error) as cause:
        raise BrokenRun(file, f"it cannot be read as CSV ({cause})") from cause
    if not rows:
        raise BrokenRun(file, "it holds no steps")
    missing = [name for name in (*BEFORE_JOINTS, "q1", *AFTER_JOINTS) if name not in rows[0]]
    if missing:
        raise BrokenRun(file, f"the column '{missing[0]}' is missing")
    steps = []
    for number, row in enumerate(rows, start=2):
        try:
            steps.append(_step(row))
        except (ValueError, TypeError) as cause:
            raise BrokenRun(file, f"line {number} is not a step ({cause})") from cause
    return ArmRun(rows[0]["arm"], tuple(steps))


def _step(row: dict[str, str]) -> ArmStep:
    def number(name: str) -> float:
        return float(row[name] or "nan")

    def three(name: str) -> tuple[float, float, float]:
        return number(f"{name}x"), number(f"{name}y"), number(f"{name}z")

    joints = [name for name in row if name.startswith("q") and name[1:].isdigit()]
    x, y, theta = (number(f"wanted_chair_{axis}") for axis in ("x", "y", "theta"))
    return ArmStep(
        motion=row["motion"],
        step=int(row["step"]),
        t=number("t"),
        joints=tuple(number(name) for name in joints),
        chair=PlanarPose(number("chair_x"), number("chair_y"), number("chair_theta")),
        hand=three("hand_"),
        hand_quaternion=(*three("hand_q"), number("hand_qw")),
        wanted=three("wanted_"),
        error=number("error"),
        error_turn=number("error_turn"),
        wanted_chair=None if isnan(x) else PlanarPose(x, y, theta),
        chair_error=number("chair_error"),
        chair_turn=number("chair_turn"),
        driven=number("driven"),
        bearing=number("bearing"),
        manipulability=number("manipulability"),
        arm_manipulability=number("arm_manipulability"),
        smallest=number("smallest"),
        damping=number("damping"),
        hits=tuple(row["hits"].split(BETWEEN_HITS)) if row["hits"] else (),
    )

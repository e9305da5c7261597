"""The sentences of the page that depend on the numbers."""

from __future__ import annotations

from collections import Counter
from importlib.metadata import version
from platform import python_version

from omnistudy.analysis.comparison import GROUPS
from omnistudy.analysis.counting import STATUSES
from omnistudy.analysis.report import Report
from omnistudy.analysis.utah2017 import WITHOUT
from omnistudy.report.style import name_of


def _with_status(report: Report, status: str) -> int:
    return sum(count.of(status) for count in report.attempts)


def key_numbers(report: Report) -> tuple[tuple[str, str], ...]:
    """Give the few numbers to see first, each with its meaning."""
    ran = _with_status(report, "completed") + _with_status(report, "timed_out")
    numbers = [
        (str(report.study.participants), f"{report.study.kind} participants"),
        (str(ran), f"trials that ran, {_with_status(report, 'completed')} to the finish"),
    ]
    for row in report.comparison:
        if row.claim.key == "mean_without" and row.point is not None:
            numbers.append(
                (f"{row.point:.1f}", "collisions a trial without feedback (thesis: 34; calibrated)")
            )
        if row.claim.key == "mean_with" and row.interval.known:
            numbers.append(
                (
                    f"{row.interval.low:.1f} to {row.interval.high:.1f}",
                    "collisions a trial with feedback, over the prior (thesis: 5)",
                )
            )
    return tuple(numbers)


def unfinished(report: Report) -> str:
    """Say which trials are missing; empty when none is."""
    missing = [
        f"{_with_status(report, status)} {status.replace('_', ' ')}"
        for status in STATUSES
        if status != "completed" and _with_status(report, status)
    ]
    if not missing:
        return ""
    planned = sum(sum(count.attempts) for count in report.attempts)
    return f"Of {planned} attempts: {', '.join(missing)}. Every mean says how many it is of."


def tally(report: Report) -> str:
    """Count the verdicts."""
    verdicts = Counter(row.verdict for row in report.comparison)
    named = [f"{verdicts[name]} {name}" for name in ("hit", "miss", "open", "calibrated")]
    return f"{len(report.comparison)} published claims: {', '.join(named)}."


def rule(report: Report) -> str:
    """State what counts as a hit."""
    source = (
        "the lowest and highest value over the quantiles of the arm-stiffness study"
        if report.arm_stiffness
        else "groups drawn again from the participants, who each carry their own draw of it (no "
        "arm-stiffness study was given)"
    )
    return (
        "A claim is a hit when the thesis's value and our interval have a number in common, a miss "
        "when they have none. Whatever needs feedback depends on how stiffly an arm holds the "
        f"stick, so there the interval covers the prior of arm stiffness: {source}. The others "
        f"have a 95 % bootstrap interval over participants ({GROUPS} groups). A wide interval "
        "makes a hit cheap: read the width. What the driver was calibrated on is not a prediction "
        "and is called so. The thesis's means are read as rounded to a whole number, “about” as "
        "within 10 %."
    )


def limits(report: Report) -> tuple[str, ...]:
    """List what the page cannot tell."""
    general = [
        "Means over trials describe this study; no test in it was planned beforehand.",
    ]
    if report.study.kind == "virtual":
        general.append(
            "The participants are simulated. The driver model is minimal: it sees a way to follow "
            "and noise, not a camera picture, and it has one prior of arm stiffness for everybody."
        )
    if report.comparison:
        general += [
            f"The driver was calibrated on “{name_of(WITHOUT)}” alone: on its mean and on the best "
            "and the worst of eight people; all else follows from that and from the prior.",
            "The map is ours, made from the thesis's bill of materials; its plan is lost, so route "
            "length, corners and with them the number of collisions need not agree.",
            "In the published order T7-T10 always come last: condition and practice are confounded "
            "there, in the thesis and here.",
            "The best and the worst of eight people are extreme values: drawing groups again "
            "cannot go beyond the people there are.",
            "The thesis counted by hand, one collision from first contact until clear, all walls "
            "one; the debounced count is in the table of conditions.",
            "Smoothness (table 5.1) and the survey (section 5.3) are not part of this report.",
        ]
    if report.times.left_out:
        general.append(
            f"Out of time: {report.times.left_out} of the trials; mean times leave them out and "
            "are too short by that."
        )
    misses = [row.claim.quantity for row in report.comparison if row.verdict == "miss"]
    if misses:
        general.append("Missed: " + "; ".join(misses) + ".")
    return tuple(general)


def commands(report: Report) -> str:
    """Give the lines that make the study and this page again."""
    study = report.study.name
    if not report.comparison:
        return f"omnistudy report {study}"
    with_arms = f" --arm-study {report.arm_stiffness.study}" if report.arm_stiffness else ""
    return f"omnistudy demo\nomnistudy report {study}{with_arms}"


def facts(report: Report) -> tuple[tuple[str, str], ...]:
    """Give what identifies the study and the software."""
    study = report.study
    return (
        ("design hash", study.design_hash),
        ("site hash", study.site_hash),
        ("study made by", f"omnistudy {study.made_by}"),
        (
            "page made by",
            ", ".join(f"{name} {number}" for name, number in _software(report)),
        ),
    )


def _software(report: Report) -> tuple[tuple[str, str], ...]:
    return (
        *report.study.software,
        ("matplotlib", version("matplotlib")),
        ("Python", python_version()),
    )

"""The sentences of the page that depend on the numbers."""

from __future__ import annotations

from collections import Counter
from importlib.metadata import version
from platform import python_version

from omnistudy.analysis.comparison import GROUPS, OVER_DRAWS, OVER_PRIOR
from omnistudy.analysis.counting import RAN, STATUSES
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
    """Say which trials did not run to an end; empty when all did."""
    missing = [
        f"{_with_status(report, status)} {status}"
        for status in STATUSES
        if status not in RAN and _with_status(report, status)
    ]
    if not missing:
        return ""
    planned = sum(sum(count.attempts) for count in report.attempts)
    return f"Of {planned} attempts: {', '.join(missing)}. Every mean says how many it is of."


def left_out(report: Report) -> str:
    """Say which attempts the protocol's limits leave out, and why; empty when none."""
    if not report.exclusions:
        return ""
    reasons: dict[int, list[str]] = {}
    for trial, measure, value, greatest, unit in report.exclusions:
        shown = "" if unit == "1" else f" {unit}"
        reasons.setdefault(trial, []).append(
            f"{measure.replace('_', ' ')} {value:g}{shown}, limit {greatest:g}{shown}"
        )
    named = "; ".join(f"{trial} ({', '.join(why)})" for trial, why in reasons.items())
    return f"Left out of all numbers, being above the protocol's limits: trial {named}."


def out_of_time(report: Report) -> str:
    """Say whose time ran out and what that does to the means; empty when nobody's did."""
    late = [
        f"{count.of('timed_out')} of {count.of('completed') + count.of('timed_out')} trials "
        f"“{name_of(count.condition)}”"
        for count in report.attempts
        if count.of("timed_out")
    ]
    if not late:
        return ""
    why = (
        " Feedback can hold a virtual driver whose arm is loose even at its greatest effort."
        if report.study.kind == "virtual"
        else ""
    )
    return (
        f"{', '.join(late)}. Such a trial counts with the collisions it had until then and has no "
        f"completion time, so both means are lower than they would be.{why}"
    )


def tally(report: Report) -> str:
    """Count the verdicts."""
    verdicts = Counter(row.verdict for row in report.comparison)
    named = [f"{verdicts[name]} {name}" for name in ("hit", "miss", "open", "calibrated")]
    return f"{len(report.comparison)} published claims: {', '.join(named)}."


def rule(report: Report) -> tuple[str, ...]:
    """State what counts as a hit, and what each interval covers."""
    return (
        "Hit: the thesis's value and our interval have a number in common. Miss: they have none. "
        "A wide interval makes a hit cheap: read the width.",
        "Calibrated: the driver was fitted to this number, so it predicts nothing; whether the "
        "number was met is said beside it.",
        "Whatever needs feedback depends on how stiffly an arm holds the stick, which trials "
        "without feedback cannot reveal. There the interval covers the prior of arm stiffness: "
        + _over_prior(report),
        f"Over participants: 95 % of {GROUPS} groups drawn again from this study's participants.",
        "The thesis's means are read as rounded to a whole number, “about” as within 10 %.",
    )


def _over_prior(report: Report) -> str:
    drawn_again = "groups drawn again from the participants, who each carry one draw of the prior"
    if report.arm_stiffness:
        return (
            f"lowest to highest value over its quantiles ({OVER_PRIOR}); what needs three trials a "
            f"person has {drawn_again} ({OVER_DRAWS})."
        )
    return (
        f"{drawn_again} ({OVER_DRAWS}). No arm-stiffness study was given: `omnistudy demo` makes "
        f"one, `omnistudy report {report.study.name} --arm-study utah2017_arm_stiffness` uses it."
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
            "People counted the thesis's collisions by hand and wrote them on paper; we count as "
            "its code does, every new contact. The table of conditions has the debounced count "
            "too.",
            "Smoothness (table 5.1) and the survey (section 5.3) are not part of this report.",
        ]
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

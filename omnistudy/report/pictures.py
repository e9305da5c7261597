"""The figures of the first report, in their order, with captions and what the thesis says."""

from __future__ import annotations

from omnistudy.analysis.arm_stiffness import ArmStiffnessCurve
from omnistudy.analysis.outcomes import Outcomes
from omnistudy.analysis.report import Report, Subject
from omnistudy.report.draw_arm_stiffness import arm_stiffness_tables, draw_arm_stiffness
from omnistudy.report.draw_outcomes import draw_outcomes, outcome_tables
from omnistudy.report.draw_paths import draw_paths, path_tables
from omnistudy.report.draw_wrenches import draw_wrenches, wrench_tables
from omnistudy.report.picture import Picture
from omnistudy.report.style import name_of
from omnistudy.worlds import World

BARS = (
    "Bars are means, whiskers one standard deviation, dots single trials in the order of the "
    "participants' codes."
)
LABELS = (
    "T1-T3 are the trials with feedback, T4-T6 those without, T7-T9 have the compliance centre "
    "moved, T10 has no torque: labels of conditions, not the order in which they were driven. "
    "Tavg is the mean over T1-T3 and over T4-T6."
)
COUNTING = "Every trial that ran is counted, also those that ran out of time."
ARMS = (
    "Bars with feedback describe this group, in which each virtual person carries one draw of the "
    "arm-stiffness prior; the prediction is the interval in the table, not the bar."
)


def pictures(report: Report, world: World | None) -> tuple[Picture, ...]:
    """Draw every figure for which the study has trials."""
    made = [_collisions(report), _times(report)]
    if report.best and report.worst:
        made += [_subject(report, report.best, "best"), _subject(report, report.worst, "worst")]
    if report.arm_stiffness:
        made.append(_arm_stiffness(report))
    if report.wrenches:
        made.append(_wrenches(report))
    if any(paths.paths for paths in report.paths):
        made.append(_paths(report, world))
    return tuple(made)


def _collisions(report: Report) -> Picture:
    outcomes = report.collisions_by_label or report.collisions
    published = report.collisions_by_label is not None
    return _bars(
        report,
        outcomes,
        key="collisions",
        title="Collisions" + (" (thesis: figure 5.1)" if published else ""),
        axis="collisions per trial",
        caption=_joined(
            BARS,
            LABELS if published else "",
            COUNTING,
            ARMS if published and report.study.kind == "virtual" else "",
        ),
        published=(
            "34 collisions a trial without feedback, 5 with (Tavg).",
            "Both fall steeply from the first to the third trial.",
            "With feedback most people reach zero in as few as two trials; without, about 25 "
            "remain after three.",
            "With the centre moved or without torque they “appear to remain small”.",
        )
        if published
        else (),
    )


def _times(report: Report) -> Picture:
    outcomes = report.times_by_label or report.times
    published = report.times_by_label is not None
    return _bars(
        report,
        outcomes,
        key="times",
        title="Completion time" + (" (thesis: figure 5.2)" if published else ""),
        axis="seconds from the first command to the finish",
        caption=_joined(
            BARS,
            "Only completed trials have a time.",
            f"Out of time and so left out: {outcomes.left_out}; the means are too short by that."
            if outcomes.left_out
            else "",
        ),
        published=(
            "“No significant difference”; with feedback a little less. No numbers are given.",
            "The thesis puts the difference down to collisions without feedback and the effort "
            "to recover from them.",
        )
        if published
        else (),
    )


def _subject(report: Report, subject: Subject, which: str) -> Picture:
    published = {
        "best": (
            "With feedback: 1 at most, 0 from the second trial on.",
            "Without: 19 at most, 18 at the end, 17 on average.",
        ),
        "worst": (
            "With feedback: from 11 down to 4, about 7 on average.",
            "Without: from 124 down to around 60, about 83 on average.",
        ),
    }[which]
    number = {"best": "5.3", "worst": "5.4"}[which]
    return _bars(
        report,
        subject.collisions,
        key=f"{which}-participant",
        title=f"The {which} participant: {subject.participant} (thesis: figure {number})",
        axis=f"collisions of {subject.participant}",
        caption=f"The participant with the {'fewest' if which == 'best' else 'most'} collisions "
        "a trial over T1-T6 (the thesis does not say how it picked). One trial a bar; the "
        "whiskers of Tavg are the standard deviation of three trials.",
        published=published,
    )


def _bars(
    report: Report,
    outcomes: Outcomes,
    *,
    key: str,
    title: str,
    axis: str,
    caption: str,
    published: tuple[str, ...],
) -> Picture:
    alt = f"Bar chart of {axis}. " + "; ".join(
        f"{bar.place.label}: {bar.estimate.mean:.1f}"
        if bar.estimate.n
        else f"{bar.place.label}: none"
        for bar in outcomes.bars
    )
    svg = draw_outcomes(outcomes, key, alt, report.study.kind, axis)
    return Picture(key, title, alt, caption, svg, published, *outcome_tables(outcomes))


def _arm_stiffness(report: Report) -> Picture:
    curve = report.arm_stiffness
    assert curve is not None
    alt = "Curve of mean collisions with feedback over quantiles of arm stiffness. " + "; ".join(
        f"{point.quantile:g}: {point.collisions.mean:.1f}" for point in curve.points
    )
    return Picture(
        "arm-stiffness",
        "Collisions with feedback over the arm-stiffness prior",
        alt,
        "How stiffly an arm holds the stick decides how much feedback helps, and no trial without "
        "feedback can reveal it. So it is drawn from a prior, and every prediction with feedback "
        "is the whole range of this curve, never one point on it. Thick: mean over participants; "
        f"thin: each participant. From study {curve.study}, one trial a quantile and person. "
        + _out_of_time(curve),
        draw_arm_stiffness(curve, "arm-stiffness", alt, report.study.kind),
        ("5 collisions a trial with feedback. The thesis did not measure arms.",),
        *arm_stiffness_tables(curve),
    )


def _out_of_time(curve: ArmStiffnessCurve) -> str:
    late = [
        f"{point.timed_out} of {point.collisions.n} at quantile {point.quantile:g}"
        for point in curve.points
        if point.timed_out
    ]
    if not late:
        return "All reached the finish."
    return f"Out of time: {', '.join(late)}; they count with their collisions until then."


def _joined(*sentences: str) -> str:
    return " ".join(sentence for sentence in sentences if sentence)


def _wrenches(report: Report) -> Picture:
    traces = report.wrenches
    first = traces[0]
    alt = (
        f"Time courses of force and torque at the stick of participant {first.participant}, "
        f"one row a condition: {', '.join(name_of(trace.condition) for trace in traces)}."
    )
    return Picture(
        "wrench",
        "Force and torque on the hand (thesis: figure 5.6)"
        if report.comparison
        else "Force and torque on the hand",
        alt,
        f"What the law asks the stick to render, of participant {first.participant}, the first "
        f"completed trial of each condition, in {first.part}; before the stick's own limits. "
        "Force is positive forward and to the left, torque counter-clockwise.",
        draw_wrenches(traces, "wrench", alt, report.study.kind),
        (
            "Figure 5.6 draws torque over time in the green part for each compliance centre; the "
            "text gives no numbers, only that it looked smoothest with the centre at the robot's.",
        )
        if report.comparison
        else (),
        *wrench_tables(traces),
    )


def _paths(report: Report, world: World | None) -> Picture:
    alt = "Plans with driven paths and collisions. " + "; ".join(
        f"{name_of(paths.condition)}: {len(paths.paths)} trials, "
        f"{sum(len(path.collision_x) for path in paths.paths)} collisions"
        for paths in report.paths
    )
    return Picture(
        "paths",
        "Where they drove",
        alt,
        "Lines are the driven ways of every trial that ran, thinned to a point every 10 cm; dots "
        "are the places where a collision began (debounced, so fewer than new contacts).",
        draw_paths(report.paths, world, "paths", alt, report.study.kind),
        ("The thesis's plan (figure 4.10) is lost; this one is made from its bill of materials.",)
        if report.comparison
        else (),
        *path_tables(report.paths),
    )

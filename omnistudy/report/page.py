"""The page: a report's numbers and pictures as one self-contained HTML text."""

from __future__ import annotations

import csv
from base64 import b64encode
from importlib.resources import files
from io import StringIO
from math import isfinite, isinf

from jinja2 import Environment, StrictUndefined

from omnistudy.analysis.comparison import ComparisonRow
from omnistudy.analysis.counting import STATUSES
from omnistudy.analysis.estimate import Estimate, Interval
from omnistudy.analysis.report import Report
from omnistudy.report.picture import DataTable
from omnistudy.report.pictures import pictures
from omnistudy.report.style import name_of
from omnistudy.report.words import (
    commands,
    facts,
    key_numbers,
    left_out,
    limits,
    out_of_time,
    rule,
    tally,
    unfinished,
)
from omnistudy.version import VERSION
from omnistudy.worlds import World

GENERATOR = "omnistudy report"
"""Content of the page's generator tag, by which a report is known as ours."""


def render(report: Report, world: World | None) -> str:
    """Give the page; the same report gives the same text."""
    environment = Environment(
        autoescape=True, undefined=StrictUndefined, trim_blocks=False, keep_trailing_newline=True
    )
    environment.filters["short"] = short
    environment.filters["csv_uri"] = csv_uri
    here = files("omnistudy.report")
    template = environment.from_string(here.joinpath("page.html.j2").read_text(encoding="utf-8"))
    return template.render(
        generator=f"{GENERATOR} {VERSION}",
        css=here.joinpath("page.css").read_text(encoding="utf-8"),
        study=report.study,
        virtual=report.study.kind == "virtual",
        unfinished=unfinished(report),
        left_out=left_out(report),
        out_of_time=out_of_time(report),
        key_numbers=key_numbers(report),
        comparison=[_comparison_row(row) for row in report.comparison],
        tally=tally(report),
        rule=rule(report),
        pictures=pictures(report, world),
        conditions=_conditions(report),
        attempts=_attempts(report),
        events=_events(report),
        limits=limits(report),
        commands=commands(report),
        facts=facts(report),
    )


def short(value: float) -> str:
    """Write a number for a table: whole ones whole, others with what three digits need."""
    if isinstance(value, int):
        return str(value)
    if not isfinite(value):
        return "–"
    if value == round(value) or abs(value) >= 100:
        return f"{value:.0f}"
    return f"{value:.1f}" if abs(value) >= 10 else f"{value:.3g}"


def csv_uri(table: DataTable) -> str:
    """Give a table as the data URI of a CSV file."""
    text = StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table.columns)
    writer.writerows(table.rows)
    return f"data:text/csv;charset=utf-8;base64,{b64encode(text.getvalue().encode()).decode()}"


def _comparison_row(row: ComparisonRow) -> dict[str, str]:
    exact = row.claim.reads_as.low == row.claim.reads_as.high
    interval = _interval(row.interval)
    return {
        "quantity": row.claim.quantity,
        "printed": row.claim.printed,
        "reads_as": "" if exact else _interval(row.claim.reads_as),
        "ours": interval if row.point is None else f"{short(row.point)} ({interval})",
        "verdict": row.verdict,
        "met": ("met" if row.agrees else "not met") if row.claim.calibrated else "",
        "method": row.method,
        "source": row.claim.source.removeprefix("sec. 5.1, "),
    }


def _interval(interval: Interval) -> str:
    if not interval.known:
        return "not computed"
    if isinf(interval.high):
        return f"above {short(interval.low)}"
    low, high = short(interval.low), short(interval.high)
    return low if low == high else f"{low} to {high}"


def _conditions(report: Report) -> DataTable:
    rows = zip(
        report.collisions.bars, report.collisions_debounced.bars, report.times.bars, strict=True
    )
    return DataTable(
        (
            "condition",
            "name in the database",
            "trials that ran",
            "collisions, as the thesis counts",
            "collisions, debounced",
            "trials with a time",
            "time (s)",
        ),
        tuple(
            (
                name_of(bar.place.condition),
                bar.place.condition,
                bar.estimate.n,
                _mean_sd(bar.estimate),
                _mean_sd(debounced.estimate),
                time.estimate.n,
                _mean_sd(time.estimate),
            )
            for bar, debounced, time in rows
        ),
    )


def _mean_sd(estimate: Estimate) -> str:
    if not estimate.n:
        return "–"
    spread = f" ± {estimate.sd:.1f}" if isfinite(estimate.sd) else ""
    return f"{estimate.mean:.1f}{spread}"


def _attempts(report: Report) -> DataTable:
    return DataTable(
        ("condition", *(status.replace("_", " ") for status in STATUSES)),
        tuple((name_of(count.condition), *count.attempts) for count in report.attempts),
    )


def _events(report: Report) -> DataTable:
    return DataTable(
        ("event", *(name_of(name) for name in report.study.conditions), "all"),
        tuple(
            (count.kind.replace("_", " "), *count.by_condition, count.total)
            for count in report.events
        ),
    )

"""What a page that was taken from a sweep says of where it comes from."""

from __future__ import annotations

from omnistudy.analysis.sweep import DesignPoint, Ranking, Spread
from omnistudy.session.sweep.question import Sweep

ROWS_NAMED = 20
"""Rows that a line of comment names."""


def provenance(name: str, sweep: Sweep, ranking: Ranking, point: DesignPoint) -> tuple[str, ...]:
    """Give the lines: sweep, hashes, version, values, figures, rivals."""
    place = ranking.points.index(point) + 1
    rivals = [str(other.row) for other in ranking.points if other.tied and other is not point]
    named = ", ".join(rivals[:ROWS_NAMED]) + (", ..." if len(rivals) > ROWS_NAMED else "")
    met = [f"{one.key}={one.asked}" for one in sweep.variables if one.role == "nuisance"]
    return (
        f"Row {point.row} of the sweep '{name}' over {sweep.protocol}, omnistudy {sweep.version}.",
        f"design hash {sweep.design_hash}",
        f"site hash   {sweep.site_hash}",
        *(f"{key} = {value}" for key, value in zip(ranking.keys, point.values, strict=True)),
        f"{ranking.by}: mean {_spread(point.mean)}, worst tenth {_spread(point.worst_tenth)}",
        f"place {place} of {len(ranking.points)} by {ranking.order.replace('_', ' ')}; "
        + (f"not told apart from the best: rows {named}" if named else "no other row is tied"),
        f"time {point.outcomes['duration_s']:.4g} s, work against the hand "
        f"{point.outcomes['work_against_j']:.4g} J, {point.timed_out:.0%} of trials out of time",
        f"over {ranking.nuisance_points} nuisance points ({' '.join(met) or 'none swept'}) and "
        f"{ranking.participants} virtual participants, conditions {', '.join(sweep.driven)}",
    )


def _spread(spread: Spread) -> str:
    if not spread.interval.known:
        return f"{spread.value:.4g} (one participant: no interval)"
    return f"{spread.value:.4g} [{spread.interval.low:.4g}, {spread.interval.high:.4g}]"

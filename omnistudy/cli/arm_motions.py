"""What the motions of an arm came to, as a table."""

from __future__ import annotations

from math import degrees, isnan
from typing import TYPE_CHECKING

from omnistudy.cli.output import print_table

if TYPE_CHECKING:
    from omnistudy.arm.run import MotionSummary


def print_motions(found: tuple[MotionSummary, ...]) -> None:
    """Print one row a motion, in s, mm and degrees."""
    rows = [
        (
            summary.motion,
            round(summary.duration, 2),
            round(1000 * summary.worst_error, 3),
            round(degrees(summary.worst_turn), 3),
            round(1000 * summary.final_error, 3),
            round(degrees(summary.final_turn), 3),
            round(1000 * summary.driven, 1),
            round(degrees(summary.chair.theta), 2),
            None if isnan(summary.chair_error) else round(1000 * summary.chair_error, 1),
            None if isnan(summary.chair_turn) else round(degrees(summary.chair_turn), 1),
            summary.held_back,
            summary.damped,
            "yes" if summary.followed else "no",
        )
        for summary in found
    ]
    columns = (
        *("motion", "s", "worst mm", "worst deg", "final mm", "final deg", "driven mm"),
        *(
            "heading deg",
            "chair off mm",
            "chair off deg",
            "steps held back",
            "steps damped",
            "arrived",
        ),
    )
    print_table("Motions of the hand", columns, rows)

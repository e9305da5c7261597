"""What `omnistudy sweep` prints: the plan before it runs, the ranking after."""

from __future__ import annotations

from typing import TYPE_CHECKING

from omnistudy.cli.output import print_line, print_table

if TYPE_CHECKING:
    from omnistudy.analysis.estimate import Interval
    from omnistudy.analysis.sweep import Ranking
    from omnistudy.session.sweep.folder import SweepFolder
    from omnistudy.session.sweep.question import Sweep
    from omnistudy.session.sweep.run import Remaining


def print_plan(folder: SweepFolder, sweep: Sweep) -> None:
    """Print the variables and how many points and trials there are."""
    people = len({trial.participant for trial in sweep.trials})
    print_table(
        f"Sweep '{folder.name}'",
        ("key", "role", "values"),
        [(one.key, one.role, one.asked) for one in sweep.variables],
    )
    print_line(
        f"{sweep.designs * sweep.nuisances} points ({sweep.designs} design x {sweep.nuisances} "
        f"nuisance), {len(sweep.trials)} trials each: {people} participants, conditions "
        f"{', '.join(sweep.driven)}"
    )


def print_left(left: Remaining, how: str, workers: int) -> None:
    """Print what is left to run and how long it takes."""
    if not left.points:
        print_line("nothing is left to run")
        return
    took = f"about {_duration(left.seconds(workers))} ({left.seconds_a_trial:.2g} s a trial)"
    print_line(
        f"to run: {left.trials} trials at {left.points} points with {how}, {workers} "
        f"{'worker' if workers == 1 else 'workers'}: "
        f"{took if left.seconds_a_trial else 'no time is known, for the first trial fails'}"
    )


def _duration(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 90 else f"{minutes / 60:.1f} h"


def print_ranking(name: str, ranking: Ranking, shown: int) -> None:
    """Print the first rows, what cannot be told apart, and the front."""
    print_table(
        f"Sweep '{name}': {ranking.by}, ranked by {ranking.order.replace('_', ' ')}; time in s, "
        "work against the hand in J",
        (
            "row",
            *ranking.keys,
            "mean",
            "95 %",
            "worst tenth",
            "behind the best",
            "told apart",
            "time",
            "work",
            "out of time",
            "front",
        ),
        [
            (
                point.row,
                *point.values,
                round(point.mean.value, 3),
                _interval(point.mean.interval),
                round(point.worst_tenth.value, 3),
                _interval(point.behind.interval),
                not point.tied,
                round(point.outcomes["duration_s"], 1),
                round(point.outcomes["work_against_j"], 2),
                f"{point.timed_out:.0%}",
                point.in_front,
            )
            for point in ranking.points[:shown]
        ],
    )
    if len(ranking.points) > shown:
        print_line(f"{len(ranking.points) - shown} more rows: --all prints them")
    tied = [str(point.row) for point in ranking.points if point.tied]
    front = [str(point.row) for point in ranking.points if point.in_front]
    print_line(f"cannot be told apart from the best: rows {', '.join(tied)}")
    print_line(f"front of collisions, time and work against the hand: rows {', '.join(front)}")
    if ranking.left_out:
        rows = ", ".join(str(row) for row in ranking.left_out)
        print_line(f"not finished over all of the nuisance, so left out: rows {rows}")
    if ranking.participants == 1:
        print_line("one participant gives no interval, so nothing can be told apart")
    print_line(f"method: {ranking.method}; virtual participants only")


def _interval(interval: Interval) -> str | None:
    return f"{interval.low:.3g} to {interval.high:.3g}" if interval.known else None

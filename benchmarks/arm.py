"""Measure an arm's controllers: success over random tasks, doors, time of a step: `make bench-arm`.

Prints tables in Markdown. Times depend on the machine; the ratios are what to compare.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Sequence

from arm_doors import doors
from arm_step import PINK, WANTED, step_microseconds
from arm_success import CONTROLLERS, Outcome, outcomes, share
from arm_tasks import CLASSES

SEED = "published table of the arm"
TASKS = 100
WANTED_SHARE = 95.0


def main() -> None:
    """Measure everything, the quick parts first."""
    given = _arguments()
    _print_steps(step_microseconds())
    _print_doors()
    _print_success(given.seed, given.tasks, given.only or list(CONTROLLERS))


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--tasks", type=int, default=TASKS, help="of each bearing class")
    parser.add_argument("--seed", default=SEED)
    parser.add_argument("--only", nargs="*", choices=list(CONTROLLERS), help="else all")
    return parser.parse_args()


def _print_steps(medians: dict[str, float]) -> None:
    pink = medians.get(PINK)
    rows = [
        (kind, f"{us:.0f}", f"{WANTED[kind]:.0f}" if kind in WANTED else "", _ratio(us, pink))
        for kind, us in medians.items()
    ]
    _print_table(("one step", "median us", "wanted, below", "of Pink's"), rows)
    if pink is None:
        print("\nPink is missing, so there are no ratios: pip install pin-pink\n")


def _ratio(us: float, pink: float | None) -> str:
    return "" if pink is None else f"{us / pink:.2f}"


def _print_doors() -> None:
    rows = [
        (
            door.name,
            "yes" if door.planned else "no",
            str(door.tries),
            f"{door.seconds:.1f}",
            f"{door.worst_mm:.3f}",
            f"{door.worst_degrees:.3f}",
            door.answer,
        )
        for door in doors()
    ]
    columns = ("door, dual_qp", "solved", "ways", "s", "worst mm", "worst deg", "the last motion")
    _print_table(columns, rows)


def _print_success(seed: str, tasks: int, names: Sequence[str]) -> None:
    began, total, done = time.monotonic(), len(names) * len(CLASSES) * tasks, 0

    def advance() -> None:
        nonlocal done
        done += 1
        if done % 50 == 0:
            spent = time.monotonic() - began
            left = spent / done * (total - done)
            print(f"{done} of {total} tasks, {left:.0f} s remain", file=sys.stderr)

    rows = []
    for name in names:
        everything: list[Outcome] = []
        for degrees in CLASSES:
            found = outcomes(name, degrees, seed, tasks, advance)
            everything += found
            rows.append(_row(name, f"±{degrees}", found))
        rows.append(_row(name, "all", everything))
        if name == "dual_qp":
            reached = 100 * share(o.solved for o in everything).count / len(everything)
            verdict = "met" if reached >= WANTED_SHARE else "MISSED"
            rows.append((name, f"wanted: {WANTED_SHARE:.0f} %", verdict, "", "", "", ""))
    columns = (
        "controller",
        "bearing",
        "solved %",
        "hand %",
        "chair %",
        "clear of zones %",
        "refused",
    )
    _print_table(columns, rows)


def _row(name: str, bearing: str, found: Sequence[Outcome]) -> tuple[str, ...]:
    return (
        name,
        bearing,
        str(share(o.solved for o in found)),
        str(share(o.hand for o in found)),
        str(share(o.chair for o in found)),
        str(share(o.clear for o in found)),
        str(sum(o.refused for o in found)),
    )


def _print_table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    print(f"| {' | '.join(columns)} |")
    print(f"| {' | '.join('---' for _ in columns)} |")
    for row in rows:
        print(f"| {' | '.join(row)} |")
    print(flush=True)


if __name__ == "__main__":
    main()

"""What one does with a sweep that ran: list, show, take."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line, print_table
from omnistudy.cli.sweep_output import print_ranking

if TYPE_CHECKING:
    import pandas as pd

    from omnistudy.analysis.sweep import Ranking
    from omnistudy.session.sweep.folder import SweepFolder
    from omnistudy.session.sweep.question import Sweep

SHOWN = 20
"""Rows that `show` prints unless `--all` asks for more."""


def known_sweeps() -> list[str]:
    """Complete a sweep's name."""
    from omnistudy.session.sweep.folder import sweep_names

    return list(sweep_names())


def known_outcomes() -> list[str]:
    """Complete an outcome."""
    from omnistudy.analysis.sweep import OUTCOMES

    return list(OUTCOMES)


SweepArgument = Annotated[
    str | None,
    typer.Argument(
        help="A sweep's name; not needed when there is only one.", autocompletion=known_sweeps
    ),
]
By = Annotated[
    str,
    typer.Option(
        help="Rank by collisions, duration_s or work_against_j.", autocompletion=known_outcomes
    ),
]
Worst = Annotated[
    bool, typer.Option("--worst", help="Rank by the worst tenth of the nuisance, not the mean.")
]
Force = Annotated[bool, typer.Option("--force", help="Replace files that exist.")]


def list_sweeps(json: AsJson = False) -> None:
    """List the sweeps in the folder of sweeps.

    Example: omnistudy sweep list
    """
    from omnistudy.session.sweep.folder import SweepFolder, sweep_names, sweeps_folder

    rows = []
    for name in sweep_names():
        folder = SweepFolder(sweeps_folder() / name)
        sweep = folder.question()
        points = sweep.designs * sweep.nuisances
        rows.append((name, sweep.protocol, points, len(folder.done()), len(folder.failed())))
    columns = ("name", "protocol", "points", "finished", "failed")
    if json:
        print_json([dict(zip(columns, row, strict=True)) for row in rows])
    else:
        print_table("Sweeps", columns, rows)


def show(
    name: SweepArgument = None,
    by: By = "collisions",
    worst: Worst = False,
    every: Annotated[bool, typer.Option("--all", help="Print every row.")] = False,
    csv: Annotated[
        Path | None, typer.Option(help="Write the table, one row a trial, to this file.")
    ] = None,
    draw: Annotated[
        Path | None, typer.Option(help="Draw the front into this .png or .svg.")
    ] = None,
    force: Force = False,
    json: AsJson = False,
) -> None:
    """Rank a sweep's design points and say which cannot be told apart from the best.

    Also gives the front: the points that no other one beats or equals in collisions, time and work
    against the hand together.

    Example: omnistudy sweep show gains --worst --draw front.png
    """
    from dataclasses import asdict

    from omnistudy.report.draw_sweep import draw_front
    from omnistudy.session.sweep.folder import find_sweep

    folder = find_sweep(name)
    sweep, rows, ranking = _ranked(folder, by, worst)
    if csv is not None:
        if csv.exists() and not force:
            raise typer.BadParameter(f"{csv} exists; choose another name, or --force")
        rows.to_csv(csv, index=False)
    if draw is not None:
        draw_front(ranking, draw, replace=force)
    if json:
        print_json({"name": folder.name, "protocol": sweep.protocol, **asdict(ranking)})
        return
    print_ranking(folder.name, ranking, len(ranking.points) if every else SHOWN)


def _ranked(folder: SweepFolder, by: str, worst: bool) -> tuple[Sweep, pd.DataFrame, Ranking]:
    from omnistudy.analysis.sweep import rank
    from omnistudy.errors.sweep import NothingRanYet
    from omnistudy.session.sweep.folder import table

    sweep = folder.question()
    rows = table(sweep, folder.finished())
    if rows.empty:
        raise NothingRanYet(folder.name)
    ranking = rank(
        rows,
        sweep.keys("design"),
        sweep.nuisances,
        sweep.design_hash,
        by=by,
        order="worst_tenth" if worst else "mean",
    )
    return sweep, rows, ranking


def take(
    row: Annotated[int, typer.Argument(help="Row of `omnistudy sweep show`.")],
    output: Annotated[
        Path, typer.Option("--output", "-o", help="YAML page to write, such as chosen.yaml.")
    ],
    sweep: Annotated[
        str | None,
        typer.Option(
            help="A sweep's name; not needed when there is only one.", autocompletion=known_sweeps
        ),
    ] = None,
    by: By = "collisions",
    worst: Worst = False,
    force: Force = False,
) -> None:
    """Write a design point as a protocol's page that says where it comes from.

    The page rests on the sweep's protocol and names what was chosen; the nuisance is not taken.

    Example: omnistudy sweep take 3 --sweep gains -o chosen.yaml
    """
    from omnistudy.errors.sweep import RowOutOfRange
    from omnistudy.report.sweep_words import provenance
    from omnistudy.session.sweep.folder import find_sweep
    from omnistudy.session.sweep.take import take as write

    folder = find_sweep(sweep)
    question, _, ranking = _ranked(folder, by, worst)
    chosen = [point for point in ranking.points if point.row == row]
    if not chosen:
        raise RowOutOfRange(row, [point.row for point in ranking.points])
    values = dict(zip(ranking.keys, chosen[0].values, strict=True))
    lines = provenance(folder.name, question, ranking, chosen[0])
    write(question, values, lines, output, replace=force)
    print_line(f"wrote {output}: `omnistudy protocol check {output}` reads it")

"""`omnistudy sweep`: many virtual studies that differ in a few settings."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from omnistudy.cli.arguments import AsJson, ProtocolArgument
from omnistudy.cli.output import print_json, print_line, print_table, progress

if TYPE_CHECKING:
    from omnistudy.session.sweep.folder import SweepFolder
    from omnistudy.session.sweep.question import Sweep

RUN = "run"


class SweepGroup(TyperGroup):
    """Reads a first word that is no verb as the protocol of `run`."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Give the verb, or `run` with all the words."""
        if args and args[0] not in self.commands and not args[0].startswith("-"):
            args = [RUN, *args]
        return super().resolve_command(ctx, args)


app = typer.Typer(
    cls=SweepGroup,
    no_args_is_help=True,
    help="""Many virtual studies that differ in a few settings.

    `omnistudy sweep PROTOCOL KEY=VALUES...` is short for `omnistudy sweep run PROTOCOL ...`.
    """,
)


def known_sweeps() -> list[str]:
    """Complete a sweep's name."""
    from omnistudy.session.sweep.folder import sweep_names

    return list(sweep_names())


def known_launchers() -> list[str]:
    """Complete a launcher's name."""
    from omnistudy.session.sweep.launchers import LAUNCHERS

    return list(LAUNCHERS)


SweepArgument = Annotated[
    str | None,
    typer.Argument(
        help="A sweep's name; not needed when there is only one.", autocompletion=known_sweeps
    ),
]


@app.command()
def run(
    protocol: ProtocolArgument,
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="KEY=VALUES...",
            help="law.stiffness.x=100,200 is swept, as are range(100,300,50) and "
            "interval(100,300); a key with one value holds for every point; "
            "hydra.launcher.* goes to the launcher.",
        ),
    ],
    samples: Annotated[
        int | None, typer.Option(min=1, help="Points drawn from the design's intervals.")
    ] = None,
    nuisance_samples: Annotated[
        int | None,
        typer.Option(min=1, help="Points drawn from the nuisance's; as many unless given."),
    ] = None,
    nuisance: Annotated[
        list[str] | None, typer.Option(help="A swept key that one meets, not chooses.")
    ] = None,
    design: Annotated[
        list[str] | None,
        typer.Option(help="A swept key that one chooses; keys of operator are nuisance else."),
    ] = None,
    condition: Annotated[
        list[str] | None,
        typer.Option(help="Drive these conditions; those that the design keys change else."),
    ] = None,
    participants: Annotated[
        int | None, typer.Option(min=1, help="Only the first so many participants.")
    ] = None,
    trials: Annotated[
        int | None, typer.Option(min=1, help="Only the first so many trials of each.")
    ] = None,
    seed: Annotated[str, typer.Option(help="Text behind what is drawn from intervals.")] = "sweep",
    name: Annotated[
        str | None, typer.Option(help="Folder in studies/sweeps; made from what is asked else.")
    ] = None,
    launcher: Annotated[
        str | None,
        typer.Option(
            help="basic, joblib, submitit_local, submitit_slurm or ray; joblib if installed.",
            autocompletion=known_launchers,
        ),
    ] = None,
    workers: Annotated[
        int | None, typer.Option(min=1, help="Processes; as many as there are cores unless given.")
    ] = None,
    ray_address: Annotated[
        str | None, typer.Option(help="A Ray cluster that runs already, such as auto.")
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would run and how long it takes; stop.")
    ] = False,
) -> None:
    """Drive a protocol at every combination of values; a stopped sweep goes on where it was.

    Every point meets the same virtual participants and seeds. Intervals are sampled by a Sobol
    sequence.

    Example: omnistudy sweep run utah2017_component law.stiffness.x=100,200 --trials 1
    """
    from omnistudy.session.sweep.folder import SweepFolder, sweeps_folder
    from omnistudy.session.sweep.launchers import chosen_launcher, cores
    from omnistudy.session.sweep.planning import Question, Thinning, plan_sweep, sweep_name
    from omnistudy.session.sweep.run import remaining, run_sweep

    count = workers or cores()
    chosen = chosen_launcher(launcher or ("ray" if ray_address else None), count)
    words_read = tuple(word for word in words if not word.startswith("hydra."))
    sweep = plan_sweep(
        Question(
            protocol=protocol,
            words=words_read,
            nuisance=tuple(nuisance or ()),
            design=tuple(design or ()),
            samples=samples,
            nuisance_samples=nuisance_samples,
            seed=seed,
            thinning=Thinning(tuple(condition or ()), participants, trials),
        )
    )
    folder = SweepFolder(sweeps_folder() / sweep_name(sweep, name))
    if folder.path.exists() or not dry_run:
        folder.open(sweep)
    left = remaining(folder, sweep)
    _print_plan(folder, sweep)
    print_line(
        f"to run: {left.trials} trials at {len(left.points)} points with {chosen.name}, {count} "
        f"{'worker' if count == 1 else 'workers'}: about {_duration(left.seconds(count))} "
        f"({left.seconds_a_trial:.2g} s a trial)"
    )
    if dry_run:
        return
    with progress(f"sweep {folder.name}, points", len(left.points)) as advance:
        run_sweep(
            folder,
            sweep,
            left,
            chosen,
            count,
            own_settings=[word for word in words if word.startswith("hydra.")],
            ray_address=ray_address,
            finished=advance,
        )
    print_line(f"finished: `omnistudy sweep show {folder.name}` ranks its points")


@app.command()
def show(
    name: SweepArgument = None,
    by: Annotated[
        str, typer.Option(help="Rank by collisions, duration_s or work_against_j.")
    ] = "collisions",
    worst: Annotated[
        bool, typer.Option("--worst", help="Rank by the worst tenth instead of the mean.")
    ] = False,
    csv: Annotated[
        Path | None, typer.Option(help="Write the table, one row a trial, to this file.")
    ] = None,
    json: AsJson = False,
) -> None:
    """Rank a sweep's design points and say which cannot be told apart from the best.

    Example: omnistudy sweep show gains
    """
    from omnistudy.analysis.sweep import rank
    from omnistudy.errors.sweep import NothingRanYet
    from omnistudy.session.sweep.folder import find_sweep, table

    folder = find_sweep(name)
    sweep = folder.question()
    rows = table(sweep, folder.finished())
    if not len(rows):
        raise NothingRanYet(folder.name)
    if csv is not None:
        rows.to_csv(csv, index=False)
    ranking = rank(
        rows,
        sweep.keys("design"),
        len({point.nuisance for point in sweep.points}),
        sweep.design_hash,
        by=by,
        order="worst_tenth" if worst else "mean",
    )
    if json:
        print_json(ranking)
        return
    print_table(
        f"Sweep '{folder.name}', ranked by {ranking.order} of {by}",
        ("row", *ranking.keys, "mean", "worst tenth", "behind", "tied", "front", "time", "work"),
        [
            (
                point.row,
                *point.values,
                point.mean.value,
                point.worst_tenth.value,
                point.behind.value,
                point.tied,
                point.in_front,
                point.outcomes["duration_s"],
                point.outcomes["work_against_j"],
            )
            for point in ranking.points
        ],
    )
    print_line(ranking.method)


def _print_plan(folder: SweepFolder, sweep: Sweep) -> None:
    designs = len({point.design for point in sweep.points})
    nuisances = len({point.nuisance for point in sweep.points})
    people = len({trial.participant for trial in sweep.trials})
    print_table(
        f"Sweep '{folder.name}'",
        ("key", "role", "values"),
        [(one.key, one.role, one.asked) for one in sweep.variables],
    )
    print_line(
        f"{len(sweep.points)} points ({designs} design x {nuisances} nuisance) of "
        f"{len(sweep.trials)} trials each: {people} participants, "
        f"conditions {', '.join(sweep.conditions)}"
    )


def _duration(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 90 else f"{minutes / 60:.1f} h"

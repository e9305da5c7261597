"""`omnistudy sweep`: many virtual studies that differ in a few settings."""

from __future__ import annotations

from contextlib import ExitStack
from typing import TYPE_CHECKING, Annotated, Any

import typer
from typer.core import TyperGroup

from omnistudy.cli.arguments import ProtocolArgument, Workers, protocol_names
from omnistudy.cli.output import Advance, print_line, progress
from omnistudy.cli.sweep_choice import known_outcomes, list_sweeps, show, take
from omnistudy.cli.sweep_output import print_left, print_plan

if TYPE_CHECKING:
    from omnistudy.session.sweep.planning import Question, SweepPlan

RUN = "run"
PLANNED_AT_ONCE = 100
"""Points that are planned without a word."""


class SweepGroup(TyperGroup):
    """Reads a first word that is no verb as the protocol of `run`."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """Give the verb, or `run` with all the words."""
        if args and args[0] not in self.commands:
            args = [RUN, *args]
        return super().resolve_command(ctx, args)

    def shell_complete(self, ctx: Any, incomplete: str) -> Any:
        """Complete protocols beside the verbs."""
        found = super().shell_complete(ctx, incomplete)
        names = [name for name in protocol_names() if name.startswith(incomplete)]
        return [*found, *(type(found[0])(name) for name in names)] if found else found


app = typer.Typer(
    cls=SweepGroup,
    no_args_is_help=True,
    help="""Many virtual studies that differ in a few settings.

    `omnistudy sweep PROTOCOL KEY=VALUES...` is short for `omnistudy sweep run PROTOCOL ...`.

    Example: omnistudy sweep utah2017_component law.stiffness.x=100,200,400 --dry-run
    """,
)


def known_launchers() -> list[str]:
    """Complete a launcher's name."""
    from omnistudy.session.sweep.launchers import LAUNCHERS

    return list(LAUNCHERS)


@app.command()
def run(
    protocol: ProtocolArgument,
    words: Annotated[
        list[str],
        typer.Argument(
            metavar="KEY=VALUES...",
            help="law.stiffness.x=100,200 is swept, as are range(100,300,50) and "
            "interval(100,300); a key with one value holds for every point; hydra.launcher.* is "
            "for the launcher.",
        ),
    ],
    samples: Annotated[
        int | None,
        typer.Option(min=1, help="Points drawn from the intervals, or tried by a search."),
    ] = None,
    nuisance_samples: Annotated[
        int | None,
        typer.Option(min=1, help="Points drawn from intervals of the nuisance; as many else."),
    ] = None,
    nuisance: Annotated[
        list[str] | None, typer.Option(help="A swept key that one meets and does not choose.")
    ] = None,
    design: Annotated[
        list[str] | None,
        typer.Option(help="A swept key that one chooses; under operator keys are nuisance else."),
    ] = None,
    condition: Annotated[
        list[str] | None,
        typer.Option(help="Drive this condition; those that the design keys change else."),
    ] = None,
    participants: Annotated[
        int | None, typer.Option(min=1, help="Only the first so many participants.")
    ] = None,
    trials: Annotated[
        int | None, typer.Option(min=1, help="Only the first so many trials of each.")
    ] = None,
    seed: Annotated[str, typer.Option(help="Text behind what is drawn from intervals.")] = "sweep",
    search: Annotated[
        str | None,
        typer.Option(help="optuna: ask for design points one by one instead of crossing lists."),
    ] = None,
    objective: Annotated[
        str, typer.Option(help="What a search makes small.", autocompletion=known_outcomes)
    ] = "collisions",
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
    workers: Workers = None,
    ray_address: Annotated[
        str | None, typer.Option(help="Address of a Ray cluster that runs already.")
    ] = None,
    dry_run: Annotated[
        bool, typer.Option("--dry-run", help="Say what would run and how long it takes; stop.")
    ] = False,
) -> None:
    """Drive a protocol at every combination of values; a stopped sweep goes on where it was.

    Every point meets the same virtual participants and seeds. Intervals are sampled by a Sobol
    sequence; design and nuisance are crossed.

    Example: omnistudy sweep run utah2017_component law.stiffness.x=100,200 --trials 1
    """
    from omnistudy.session.sweep.planning import Question, Thinning

    question = Question(
        protocol=protocol,
        words=tuple(words),
        nuisance=tuple(nuisance or ()),
        design=tuple(design or ()),
        samples=samples,
        nuisance_samples=nuisance_samples,
        seed=seed,
        thinning=Thinning(tuple(condition or ()), participants, trials),
        objective=_objective(search, objective, launcher),
    )
    _run(question, name, launcher, workers, ray_address, dry_run)


def _objective(search: str | None, objective: str, launcher: str | None) -> str | None:
    from omnistudy.analysis.sweep import OUTCOMES
    from omnistudy.errors.sweep import UnknownOutcome
    from omnistudy.session.sweep.search import require_optuna

    if search is None:
        return None
    if search != "optuna":
        raise typer.BadParameter(f"--search {search}: only optuna is known")
    if launcher is not None:
        raise typer.BadParameter("--search runs on this machine's --workers: leave --launcher out")
    if objective not in OUTCOMES:
        raise UnknownOutcome(objective, list(OUTCOMES))
    require_optuna()
    return objective


def _run(
    question: Question,
    name: str | None,
    launcher: str | None,
    workers: int | None,
    ray_address: str | None,
    dry_run: bool,
) -> None:
    from omnistudy.session.sweep.folder import SweepFolder, sweeps_folder
    from omnistudy.session.sweep.launchers import chosen_launcher, cores
    from omnistudy.session.sweep.planning import sweep_name
    from omnistudy.session.sweep.run import remaining, run_sweep
    from omnistudy.session.sweep.search import run_search

    count = workers or cores()
    chosen = chosen_launcher(launcher or ("ray" if ray_address else None), count)
    plan = _planned(question)
    sweep = plan.sweep
    folder = SweepFolder(sweeps_folder() / sweep_name(sweep, name))
    if folder.path.exists() or not dry_run:
        folder.open(sweep)
    left = remaining(folder, sweep)
    print_plan(folder, sweep)
    print_left(left, "optuna" if sweep.search else chosen.name, count)
    if dry_run or not left.points:
        return
    with progress(f"sweep {folder.name}, points", left.points) as advance:
        if sweep.search is not None:
            run_search(folder, plan, sweep.search, count, advance)
        else:
            run_sweep(
                folder,
                sweep,
                left,
                chosen,
                count,
                own_settings=plan.asked.launcher,
                ray_address=ray_address,
                finished=advance,
            )
    print_line(f"finished: `omnistudy sweep show {folder.name}` ranks its points")


def _planned(question: Question) -> SweepPlan:
    """Plan with progress: points that cannot be put together from parts are slow to compose."""
    from omnistudy.session.sweep.planning import plan_sweep

    with ExitStack() as shown:
        advance: list[Advance] = []

        def planned(total: int) -> None:
            if total > PLANNED_AT_ONCE and not advance:
                advance.append(shown.enter_context(progress("planning points", total)))
            for step in advance:
                step()

        return plan_sweep(question, planned)


for verb, function in (("list", list_sweeps), ("show", show), ("take", take)):
    app.command(verb)(function)

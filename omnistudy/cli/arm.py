"""`omnistudy arm`: arms on wheelchairs, and tasks solved without physics."""

from __future__ import annotations

from math import degrees
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line, print_table, progress

if TYPE_CHECKING:
    from omnistudy.arm.check import PoseAnswer
    from omnistudy.arm.task import ArmTask

app = typer.Typer(no_args_is_help=True)


def _arms() -> list[str]:
    from omnistudy.arm import arm_names

    return list(arm_names())


def _tasks() -> list[str]:
    from omnistudy.arm.find import task_names

    return list(task_names())


def _controllers() -> list[str]:
    from omnistudy.session.plan_arm import arm_controllers

    return list(arm_controllers())


def _figures() -> list[str]:
    from omnistudy.arm.drawing import FIGURES

    return list(FIGURES)


ArmArgument = Annotated[
    str, typer.Argument(help="An arm's name or its YAML file.", autocompletion=_arms)
]
TaskArgument = Annotated[
    str, typer.Argument(help="An arm task's name or its YAML file.", autocompletion=_tasks)
]
Force = Annotated[bool, typer.Option("--force", help="Replace an existing file.")]
ControllerOption = Annotated[
    str | None,
    typer.Option(
        help="Kind of controller, with its defaults, for every motion; else the task's own.",
        autocompletion=_controllers,
    ),
]


@app.command("list")
def list_arms(as_json: AsJson = False) -> None:
    """List the arms and the tasks that can be given by name.

    Example: omnistudy arm list
    """
    from omnistudy.arm import load_arm
    from omnistudy.arm.find import load_task

    arms = [(name, load_arm(name).title) for name in _arms()]
    tasks = [(name, load_task(name).title) for name in _tasks()]
    if as_json:
        listed = {"arms": arms, "tasks": tasks}
        print_json(
            {
                key: [{"name": name, "title": title} for name, title in rows]
                for key, rows in listed.items()
            }
        )
        return
    print_table("Arms", ("name", "title"), arms)
    print_table("Tasks", ("name", "title"), tasks)


@app.command()
def show(arm: ArmArgument, as_json: AsJson = False) -> None:
    """Show an arm's joints with their limits, and its chair.

    Example: omnistudy arm show wmra1
    """
    from omnistudy.arm import load_arm

    profile = load_arm(arm)
    if as_json:
        print_json(profile)
        return
    print_line(profile.title)
    joints = [
        (
            number,
            round(degrees(joint.alpha), 3),
            joint.a,
            joint.d,
            round(degrees(joint.lower), 3),
            round(degrees(joint.upper), 3),
            joint.top_speed,
        )
        for number, joint in enumerate(profile.joints, start=1)
    ]
    columns = ("joint", "alpha deg", "a m", "d m", "lower deg", "upper deg", "top rad/s")
    print_table("Joints (Craig's modified notation)", columns, joints)
    print_line(f"gripper: {profile.gripper:g} m")
    print_table("Chair", ("what", "m, m/s, rad/s"), profile.chair.model_dump().items())
    zones = [(z.name, z.guards, z.joint) for z in profile.zones]
    print_table("Zones", ("name", "guards", "against joint"), zones)


@app.command()
def urdf(
    arm: ArmArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="URDF file to write.")],
    force: Force = False,
) -> None:
    """Write an arm on its chair as URDF; the chair slides and turns on three joints.

    Example: omnistudy arm urdf wmra1 -o wmra1.urdf
    """
    from omnistudy.arm import load_arm
    from omnistudy.arm.run_file import write_text
    from omnistudy.arm.urdf import urdf

    write_text(output, urdf(load_arm(arm)), replace=force)
    print_line(f"wrote {output}")


@app.command()
def check(task: TaskArgument, controller: ControllerOption = None, as_json: AsJson = False) -> None:
    """Say before anything moves whether a task can be done, and from where.

    With dual_qp every motion is planned: it says how hand and chair go. With the published
    controllers each pose is looked at, each motion being taken to begin in the stand-off found for
    the one before. Exit 1 when one cannot be reached.

    Example: omnistudy arm check door_right --controller dual_qp
    """
    from omnistudy.session.plan_arm import is_led

    page = _task(task, controller)
    answers = _planned(page) if is_led(page) else _looked_at(page)
    if as_json:
        print_json([answer._asdict() for answer in answers])
    else:
        rows = [(a.motion, a.share, a.possible, a.answer) for a in answers]
        print_table(task, ("motion", "share of its path", "possible", "answer"), rows)
    if not all(answer.possible for answer in answers):
        raise typer.Exit(1)


def _looked_at(page: ArmTask) -> list[PoseAnswer]:
    from omnistudy.arm.check import check_task, looks

    with progress("poses", looks(page)) as advance:
        checked = check_task(page, advance)
    return [pose.in_numbers for pose in checked.poses]


def _planned(page: ArmTask) -> list[PoseAnswer]:
    from omnistudy.session.plan_arm import MOST_TRIES, look_for_plan

    with progress("ways", MOST_TRIES) as advance:
        plan = look_for_plan(page, advance)
    return [motion.answer for motion in plan.motions] if plan.refused is None else [plan.refused]


@app.command()
def solve(
    task: TaskArgument,
    output: Annotated[Path, typer.Option("--output", "-o", help="CSV file: one row a step.")],
    controller: ControllerOption = None,
    unchecked: Annotated[
        bool,
        typer.Option(
            "--unchecked", help="Run it even if it cannot be reached; not where it is planned."
        ),
    ] = False,
    force: Force = False,
    as_json: AsJson = False,
) -> None:
    """Run a task without physics, and write every step.

    A task that no chair pose makes possible is refused before anything moves.

    Example: omnistudy arm solve reach --controller sri_wln -o reach.csv
    """
    from omnistudy.arm.check import looks
    from omnistudy.arm.run import summaries
    from omnistudy.arm.run_file import may_write, write_run
    from omnistudy.cli.arm_motions import print_motions
    from omnistudy.session.plan_arm import MOST_TRIES, is_led, plan_task
    from omnistudy.session.solve_arm import refuse_impossible, solve_task

    page = _task(task, controller)
    may_write(output, replace=force)
    plan = None
    if is_led(page):
        if unchecked:
            raise typer.BadParameter(
                "a controller that leads the chair too runs only what it planned",
                param_hint="--unchecked",
            )
        with progress("ways", MOST_TRIES) as advance:
            plan = plan_task(page, advance)
    elif not unchecked:
        with progress("poses", looks(page)) as advance:
            refuse_impossible(page, advance)
    with progress("motions", len(page.motions)) as advance:
        run = solve_task(page, advance, plan)
    write_run(run, output, replace=force)
    found = summaries(run)
    if as_json:
        print_json([summary._asdict() for summary in found])
        return
    print_motions(found)
    print_line(f"wrote {output}: {len(run.steps)} steps")


def _task(name: str, controller: str | None) -> ArmTask:
    from omnistudy.arm.find import load_task

    page = load_task(name)
    return page if controller is None else _led_by(page, controller)


def _led_by(task: ArmTask, controller: str) -> ArmTask:
    """Put one controller, with its defaults, in the place of all that a task names."""
    from omnistudy.registry import load_kind

    chosen = load_kind("controllers", controller)()
    motions = tuple(m.model_copy(update={"controller": None}) for m in task.motions)
    return task.model_copy(update={"controller": chosen, "motions": motions})


@app.command()
def plot(
    run: Annotated[Path, typer.Argument(help="CSV file that `arm solve` wrote.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Picture: .svg or .png.")],
    figures: Annotated[
        list[str] | None,
        typer.Option(
            "--figure",
            help="Figure of the thesis: 18, 19, 21, 22 or 23; may be repeated. All unless given.",
            autocompletion=_figures,
        ),
    ] = None,
    force: Force = False,
) -> None:
    """Draw a run as figures 18, 19 and 21 to 23 of Farelo (2009).

    Example: omnistudy arm plot reach.csv -o reach.svg --figure 22
    """
    from omnistudy.arm.drawing import FIGURES, write_figures
    from omnistudy.arm.run_file import read_run

    unknown = [name for name in figures or () if name not in FIGURES]
    if unknown:
        raise typer.BadParameter(f"no figure {unknown[0]}; there are {', '.join(FIGURES)}")
    chosen = [name for name in FIGURES if not figures or name in figures]
    write_figures(read_run(run), output, chosen, replace=force)
    print_line(f"drawn: {output}")

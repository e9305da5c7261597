"""`omnistudy new`: a commented file and its test in the lab's folder, to start one's own with."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line

if TYPE_CHECKING:
    from omnistudy.lab import Started

app = typer.Typer(no_args_is_help=True)

NameArgument = Annotated[
    str, typer.Argument(help="What files and pages call it: small letters, digits, underscores.")
]
Into = Annotated[
    Path | None,
    typer.Option(
        help="The lab's folder, created when missing; else OMNISTUDY_CONF, else ./lab.",
        file_okay=False,
    ),
]
DryRun = Annotated[bool, typer.Option("--dry-run", help="Say what would be written, and stop.")]


@app.command()
def law(
    name: NameArgument, into: Into = None, dry_run: DryRun = False, json: AsJson = False
) -> None:
    """Start a law: a Python file that works, its page, its test, and the package they need.

    Example: omnistudy new law grip
    """
    _start("law", name, into, dry_run, json)


@app.command()
def controller(
    name: NameArgument, into: Into = None, dry_run: DryRun = False, json: AsJson = False
) -> None:
    """Start a controller: a Python file that works, its page, its test, and the package.

    Example: omnistudy new controller smooth_rate
    """
    _start("controller", name, into, dry_run, json)


@app.command()
def world(
    name: NameArgument, into: Into = None, dry_run: DryRun = False, json: AsJson = False
) -> None:
    """Start a world: a page with a small maze, and a test that it can be driven.

    Example: omnistudy new world slalom
    """
    _start("world", name, into, dry_run, json)


@app.command()
def protocol(
    name: NameArgument, into: Into = None, dry_run: DryRun = False, json: AsJson = False
) -> None:
    """Start a protocol: a page with two conditions and virtual participants, and its test.

    Example: omnistudy new protocol grip_or_not
    """
    _start("protocol", name, into, dry_run, json)


@app.command()
def survey(
    name: NameArgument, into: Into = None, dry_run: DryRun = False, json: AsJson = False
) -> None:
    """Start a survey: a page with one item of each kind, and its test.

    Example: omnistudy new survey after_driving
    """
    _start("survey", name, into, dry_run, json)


def _start(noun: str, name: str, into: Path | None, dry_run: bool, json: bool) -> None:
    from omnistudy.lab import default_folder, next_steps, plan_start, write_start

    started = plan_start(noun, name, into or default_folder())
    if not dry_run:
        write_start(started)
    steps = next_steps(started)
    if json:
        files = [{"file": file.path, "adds": file.adds} for file in started.files]
        print_json({"written": not dry_run, "files": files, "next": steps})
        return
    _print_files(started, dry_run)
    if not dry_run:
        print_line("next:")
        for step in steps:
            print_line(f"  {step}")


def _print_files(started: Started, dry_run: bool) -> None:
    write, add = ("would write", "would add a line to") if dry_run else ("wrote", "added a line to")
    for file in started.files:
        print_line(f"{add if file.adds else write} {file.path}")

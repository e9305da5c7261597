"""`omnistudy drive WORLD`: driving freely, live, with device, recorder and pages."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

import typer
from typer.core import TyperGroup

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.kind_verbs import names_of
from omnistudy.cli.output import print_json, print_line

if TYPE_CHECKING:
    from omnistudy.session.driven import Driven

DEFAULT_VERB = "free"


class WorldOrVerb(TyperGroup):
    """Lets `drive WORLD` stand for `drive free WORLD`."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Put the verb in where the line begins with a world."""
        if args and not args[0].startswith("-") and args[0] not in self.commands:
            args = [DEFAULT_VERB, *args]
        return super().parse_args(ctx, args)


def _worlds() -> list[str]:
    from omnistudy.session.parts import part_names

    return list(part_names("world"))


def _option(help_text: str, group: str) -> Any:
    return typer.Option(help=help_text, autocompletion=names_of(f"{group}s"))


def free(
    world: Annotated[str, typer.Argument(help="World, by name or file.", autocompletion=_worlds)],
    device: Annotated[str, _option("What is held, such as serial_stick.", "device")],
    law: Annotated[str, _option("What the stick makes the hand feel.", "law")] = "component",
    controller: Annotated[
        str, _option("From the stick's position to the robot's command.", "controller")
    ] = "rate",
    plant: Annotated[str, _option("The robot.", "plant")] = "youbot",
    route: Annotated[
        str, typer.Option(help="Route of the world, to be driven to its end; none: go anywhere.")
    ] = "",
    hand: Annotated[
        Literal["person", "virtual"],
        typer.Option(help="Who holds the device: a person, or the virtual driver."),
    ] = "person",
    minutes: Annotated[
        float, typer.Option(min=0.01, help="How long a drive without a route may last.")
    ] = 10.0,
    seed: Annotated[int, typer.Option(help="Of the virtual driver.")] = 1,
    output: Annotated[
        Path | None,
        typer.Option(help="Study file to make; studies/drives/WORLD_TIME.db unless given."),
    ] = None,
    open_browser: Annotated[
        bool, typer.Option("--open/--no-open", help="Open the pages in the browser.")
    ] = True,
    json: AsJson = False,
) -> None:
    """Drive freely through a world, live; `omnistudy drive WORLD` is short for it.

    Starts the device, the simulation, the recorder and both pages, and ends them with the drive.
    Ctrl-C, or stop on a page, ends it. What was driven is kept as a small study of one trial.

    Example: omnistudy drive free primitive_a --device emulated_stick --hand virtual
    """
    from datetime import datetime

    from omnistudy.cli.live_run import run_with_pages
    from omnistudy.session.driven import driven
    from omnistudy.session.free_drive import DriveParts, drive_file, make_drive

    path = output or drive_file(world, datetime.now())
    parts = DriveParts(world, device, law, controller, plant, route, hand, minutes, seed)
    make_drive(parts, path)
    try:
        run_with_pages(path, open_browser=open_browser, pauses=False)
    except BaseException as end:
        if driven(path) is None:  # nothing was driven: there is nothing to keep
            path.unlink()
            raise
        if not isinstance(end, KeyboardInterrupt):
            raise
    done = driven(path)
    assert done is not None
    if json:
        print_json(done)
    else:
        _print_driven(done)


def _print_driven(done: Driven) -> None:
    reason = f" ({done.reason})" if done.reason else ""
    drove = done.duration_s == done.duration_s  # not a number where nothing was ever commanded
    came_to = (
        f"after {done.duration_s:.1f} s and {done.path_length_m:.2f} m" if drove else "at rest"
    )
    print_line(f"{done.status}{reason} {came_to}, {done.collisions} collisions")
    for measure in done.measures:
        print_line(f"{measure.name:24} {measure.value:g} {measure.unit.replace('1', '')}".rstrip())
    print_line(f"kept in {done.file}; see it again: omnistudy replay {done.file} {done.trial}")

"""The command `omnistudy`: the table of nouns, the options of all, and what a mistake looks like.

A noun's module is imported when the noun is used, so that `omnistudy --help` stays quick.
"""

from __future__ import annotations

import os
import sys
from importlib import import_module
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import typer
from typer.core import TyperCommand, TyperGroup
from typer.main import get_command, get_group

from omnistudy.errors import OmnistudyError
from omnistudy.version import VERSION

INTERRUPTED = 130
"""Exit status after Ctrl-C, as shells have it (128 + SIGINT)."""


class Noun(NamedTuple):
    """One row of the command line's first column.

    help : one line.
    plain : the noun is a command by itself and has no verbs.
    """

    help: str
    plain: bool = False


NOUNS = {
    "demo": Noun("The published study with virtual participants.", True),
    "new": Noun("Start a law, controller, world, protocol or survey of your own."),
    "protocol": Noun("Protocols: what is to be run."),
    "study": Noun("Studies: who runs a protocol, in a database."),
    "participant": Noun("Participants of a study."),
    "session": Noun("A participant's trials: plan them, run them."),
    "law": Noun("Laws that make the force on the stick."),
    "controller": Noun("Controllers: from the stick's position to the robot's command."),
    "plant": Noun("Robots in their physics."),
    "device": Noun("What is held: the joystick and its stand-ins."),
    "world": Noun("Worlds to drive through."),
    "arm": Noun("Arms on wheelchairs, and tasks solved without physics."),
    "task": Noun("What is to be done in a trial."),
    "operator": Noun("Who drives: the virtual driver, a recording."),
    "order": Noun("Orders: who meets which condition when."),
    "survey": Noun("Instruments: what people are asked."),
    "drive": Noun("Drive without a study: freely and live, recordings, the virtual driver."),
    "sweep": Noun("Many virtual studies that differ in a few settings."),
    "view": Noun("A study's pages in the browser.", True),
    "replay": Noun("A stored trial seen again: a page, pictures, a video.", True),
    "report": Noun("A study's report as one HTML file.", True),
}
"""Noun -> its help; its verbs live in `omnistudy.cli.<noun>` as `app`."""


class LazyNoun(TyperCommand):
    """Stands for a noun in help and completion, and imports its module when it is used."""

    def __init__(self, name: str, noun: Noun) -> None:
        super().__init__(name=name, help=noun.help, rich_markup_mode=None)
        self.noun_name = name
        self.noun = noun

    def load(self) -> TyperGroup | TyperCommand:
        """Import the noun's module and give its real command."""
        app: typer.Typer = import_module(f"omnistudy.cli.{self.noun_name}").app
        app.rich_markup_mode = None
        command = get_command(app) if self.noun.plain else get_group(app)
        assert isinstance(command, TyperGroup | TyperCommand)
        command.name = self.noun_name
        command.help = command.help or self.noun.help
        return command

    def make_context(self, *args: Any, **kwargs: Any) -> Any:
        """Hand the rest of the line to the real command."""
        return self.load().make_context(*args, **kwargs)


root = typer.Typer(
    name="omnistudy",
    rich_markup_mode=None,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)


def _print_version(wanted: bool) -> None:
    if wanted:
        print(f"omnistudy {VERSION}")
        raise typer.Exit


@root.callback()
def options_of_all(
    conf: Annotated[
        Path | None,
        typer.Option(
            help="Your lab's folder of YAML files, which come before ours; else OMNISTUDY_CONF.",
            exists=True,
            file_okay=False,
        ),
    ] = None,
    debug: Annotated[
        bool, typer.Option("--debug", help="Show the trace of an error; works after a verb too.")
    ] = False,
    version: Annotated[
        bool,
        typer.Option(
            "--version", help="Print the version.", callback=_print_version, is_eager=True
        ),
    ] = False,
) -> None:
    """Run and analyse studies in which a person drives a robot through a force-feedback stick.

    Example: omnistudy demo --quick
    """
    if conf is not None:
        os.environ["OMNISTUDY_CONF"] = str(conf.resolve())


def command_tree() -> TyperGroup:
    """Give the whole command line; nouns are `LazyNoun` until they are used."""
    tree = get_command(root)
    assert isinstance(tree, TyperGroup)
    tree.commands.update({name: LazyNoun(name, noun) for name, noun in NOUNS.items()})
    return tree


def main() -> None:
    """Run the command line; exits 0, 1 when something failed, 2 when the usage was wrong."""
    arguments, debug = _take_debug(sys.argv[1:])
    try:
        command_tree().main(args=arguments, prog_name="omnistudy")
    except SystemExit as end:
        if end.code == INTERRUPTED:
            _say("stopped: what was finished is stored, the unfinished part is not")
        _flush(end.code)
    except OmnistudyError as mistake:
        if debug:
            raise
        _say(f"error: {mistake}")
        _flush(1)
    except Exception as bug:
        if debug:
            raise
        _say(
            f"error: this is a bug in omnistudy ({type(bug).__name__}: {_one_line(bug)}); "
            "run the command again with --debug and report what it prints"
        )
        _flush(1)


def _take_debug(arguments: list[str]) -> tuple[list[str], bool]:
    """Take `--debug` out of the line wherever it stands before a `--`."""
    end = arguments.index("--") if "--" in arguments else len(arguments)
    kept = [word for word in arguments[:end] if word != "--debug"]
    return kept + arguments[end:], len(kept) < end


def _say(sentence: str) -> None:
    print(sentence, file=sys.stderr)


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split())


def _flush(status: Any) -> None:
    """Exit; a reader that closed the pipe early (`| head`) is no error worth a trace."""
    try:
        sys.stdout.flush()
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    sys.exit(status)

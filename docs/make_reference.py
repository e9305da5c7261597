"""Write docs/reference/command-line.md from the help of the commands: `make reference`."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import typer
from typer.core import TyperCommand, TyperGroup

from omnistudy.cli.app import LazyNoun, command_tree

PAGE = Path(__file__).parent / "reference" / "command-line.md"
WIDTH = 88
HEAD = """\
# The command line

One grammar everywhere: `omnistudy NOUN VERB`. `make reference` writes this page from the help of
each command; a test tells when it is stale.

Exit status: 0 done, 1 failed (one sentence says why), 2 wrong usage, 130 stopped by Ctrl-C.
"""


def commands() -> Iterator[tuple[str, TyperCommand | TyperGroup, typer.Context]]:
    """Give every command with its full name ("omnistudy law probe") and its context."""
    tree = command_tree()
    yield from _below(
        "omnistudy", tree, typer.Context(tree, info_name="omnistudy", **tree.context_settings)
    )


def _below(
    path: str, command: TyperCommand | TyperGroup, context: typer.Context
) -> Iterator[tuple[str, TyperCommand | TyperGroup, typer.Context]]:
    yield path, command, context
    if not isinstance(command, TyperGroup):
        return
    for name in command.list_commands(context):
        child = command.commands[name]
        real = child.load() if isinstance(child, LazyNoun) else child
        assert isinstance(real, TyperCommand | TyperGroup)
        below = typer.Context(real, info_name=name, parent=context, terminal_width=WIDTH)
        yield from _below(f"{path} {name}", real, below)


def page() -> str:
    """Give the page's text."""
    parts = [HEAD]
    for path, command, context in commands():
        context.terminal_width = WIDTH
        lines = command.get_help(context).rstrip().splitlines()
        text = "\n".join(line.rstrip() for line in lines)
        parts.append(f"{'###' if path.count(' ') > 1 else '##'} {path}\n\n```text\n{text}\n```\n")
    return "\n".join(parts)


if __name__ == "__main__":
    PAGE.parent.mkdir(exist_ok=True)
    PAGE.write_text(page(), encoding="utf-8")

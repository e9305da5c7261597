"""`omnistudy controller`: how the stick's position becomes a command."""

from __future__ import annotations

import typer

from omnistudy.cli.kind_verbs import add_list_and_show

app = typer.Typer(no_args_is_help=True)
add_list_and_show(app, "controller", "rate")

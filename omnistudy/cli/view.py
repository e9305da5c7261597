"""`omnistudy view`: a study's pages in the browser."""

from __future__ import annotations

from typing import Annotated

import typer

from omnistudy.cli.arguments import StudyArgument, Unmask
from omnistudy.cli.output import print_line

app = typer.Typer(add_completion=False)


@app.command()
def view(
    study: StudyArgument,
    host: Annotated[
        str, typer.Option(help="Address to listen at; other machines reach any but this.")
    ] = "127.0.0.1",
    port: Annotated[int, typer.Option(min=0, max=65535, help="Port; 0 takes a free one.")] = 0,
    token: Annotated[
        str | None, typer.Option(help="Word that opens the pages; made up unless given.")
    ] = None,
    unmask: Unmask = False,
    open_browser: Annotated[
        bool, typer.Option("--open/--no-open", help="Open the page in the browser.")
    ] = True,
) -> None:
    """Serve a study's trials, and the monitor of one that is driven, until Ctrl-C.

    Conditions are called by their masked labels.

    Example: omnistudy view first
    """
    import webbrowser

    from omnistudy.study import resolve_study
    from omnistudy.view.server import serve

    def ready(address: str) -> None:
        print_line(address)
        if open_browser:
            webbrowser.open(address)

    serve(resolve_study(study), host=host, port=port, token=token, unmask=unmask, ready=ready)

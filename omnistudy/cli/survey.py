"""`omnistudy survey`: instruments, what people are asked."""

from __future__ import annotations

from typing import Annotated

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line, print_table

app = typer.Typer(no_args_is_help=True)


def _names() -> list[str]:
    from omnistudy.survey import instrument_names

    return list(instrument_names())


@app.command("list")
def list_(json: AsJson = False) -> None:
    """List the instruments of your lab and ours, faulty ones too.

    Example: omnistudy survey list
    """
    from omnistudy.survey import listed_instruments

    entries = listed_instruments()
    if json:
        print_json([entry._asdict() for entry in entries])
        return
    rows = [
        (one.name, one.title, one.language, one.items, one.file, one.fault or None)
        for one in entries
    ]
    print_table("Surveys", ("name", "title", "language", "items", "file", "fault"), rows)


@app.command()
def show(
    survey: Annotated[
        str, typer.Argument(help="An instrument's name or its YAML file.", autocompletion=_names)
    ],
    json: AsJson = False,
) -> None:
    """Show an instrument's items, their answers and the conditions that they ask about.

    Example: omnistudy survey show utah2017
    """
    from omnistudy.survey import load_instrument

    shown = load_instrument(survey)
    if json:
        print_json(shown)
        return
    print_line(f"{shown.title} ({shown.language})")
    print_line(f"source: {shown.source}")
    if shown.introduction:
        print_line(shown.introduction)
    rows = [
        (
            number,
            item.name,
            item.question,
            item.answers,
            ", ".join(item.conditions) or None,
            item.required,
            item.source or None,
        )
        for number, item in enumerate(shown.items, 1)
    ]
    columns = ("no.", "item", "question", "answers", "asks about", "required", "source")
    print_table("Items", columns, rows)

"""The verbs `list` and `show`, alike for every noun whose things are kinds."""

# No postponed annotations here: typer must see the completion of each noun, a local value.
from collections.abc import Callable, Sequence
from typing import Annotated, Any, NamedTuple

import typer

from omnistudy.cli.arguments import AsJson
from omnistudy.cli.output import print_json, print_line, print_table

Recorded = tuple[str, str, str]
"""Name, unit and meaning of a channel."""

Channels = Callable[[Any], Sequence[Recorded]]
"""From an object of a kind to what it records."""


class Present(NamedTuple):
    """Things of a noun that are here now, as a list shows them below its pages.

    key : in JSON. remarks : one sentence each, below the table.
    """

    title: str
    key: str
    columns: Sequence[str]
    rows: Sequence[Sequence[str]]
    remarks: Sequence[str]


def kinds_of(group: str) -> Callable[[], list[str]]:
    """Give what completes a kind of a group ("laws")."""

    def complete() -> list[str]:
        from omnistudy.registry import kinds

        return list(kinds(group))

    return complete


def names_of(group: str) -> Callable[[], list[str]]:
    """Give what completes a name of a group ("laws"): its kinds and its pages."""

    def complete() -> list[str]:
        from omnistudy.registry.catalogue import names

        return list(names(group))

    return complete


def add_list_and_show(
    app: typer.Typer,
    noun: str,
    example: str,
    channels: Channels | None = None,
    present: Callable[[], Present] | None = None,
) -> None:
    """Give a noun its two verbs.

    noun : "law"; its kinds are the group "laws", its pages stand in the folder `law`.
    example : what the help shows.
    channels : what an object of this group records, where it records anything.
    present : what is here now, where such things can be plugged in.
    """
    group = f"{noun}s"
    here = ", and what is plugged in" if present else ""

    def list_(json: AsJson = False) -> None:
        _list(group, json, present)

    def show(
        name: Annotated[
            str,
            typer.Argument(
                help=f"A kind or a page; `omnistudy {noun} list` names them.",
                autocompletion=names_of(group),
            ),
        ],
        json: AsJson = False,
    ) -> None:
        _show(group, name, json, channels)

    app.command(
        "list",
        help=f"List the kinds of {group}, also installed packages', and the pages of your lab "
        f"and ours{here}.\n\nExample: omnistudy {noun} list",
    )(list_)
    app.command(
        "show",
        help="Show every parameter with its default, unit, meaning and source, and what a page "
        f"sets.\n\nExample: omnistudy {noun} show {example}",
    )(show)


def _list(group: str, json: bool, present: Callable[[], Present] | None) -> None:
    from omnistudy.registry.catalogue import entries, pages

    kinds, listed = entries(group), pages(group)
    here = present() if present else None
    if json:
        shown: dict[str, Any] = {
            "kinds": [entry._asdict() for entry in kinds],
            "pages": [
                {"name": page.name, "kind": page.kind, "summary": page.summary, "file": page.file}
                for page in listed
            ],
        }
        if here is not None:
            found = [dict(zip(here.columns, row, strict=True)) for row in here.rows]
            shown |= {here.key: found, "remarks": here.remarks}
        print_json(shown)
        return
    print_table(f"Kinds of {group}", ("kind", "what it is", "from"), kinds)
    if listed:
        rows = [(page.name, page.kind, page.summary or None, page.file) for page in listed]
        print_table("Pages", ("name", "kind", "what it says", "file"), rows)
    if here is not None:
        if here.rows:
            print_table(here.title, here.columns, here.rows)
        else:
            print_line(f"{here.title}: nothing")
        for remark in here.remarks:
            print_line(remark)


def _show(group: str, name: str, json: bool, channels: Channels | None) -> None:
    from omnistudy.registry import load_kind
    from omnistudy.registry.catalogue import find
    from omnistudy.registry.parameters import parameters

    entry, page = find(group, name)
    chosen = load_kind(group, entry.kind)
    rows = parameters(chosen)
    # What an object records is known only of an object: a kind with a gap makes none.
    complete = channels is not None and not any(row.required for row in rows)
    recorded = channels(chosen()) if channels is not None and complete else ()
    if json:
        shown: dict[str, Any] = entry._asdict()
        shown["parameters"] = [row._asdict() for row in rows]
        shown["page"] = page and {"file": page.file, "sets": dict(page.sets)}
        if channels is not None:
            keys = ("name", "unit", "meaning")
            shown["channels"] = [dict(zip(keys, row, strict=True)) for row in recorded]
        print_json(shown)
        return
    print_line(entry.summary)
    if rows:
        shown_rows = [
            (row.name, "must be given" if row.required else row.default, row.unit, row.meaning)
            for row in rows
        ]
        columns = ("name", "default", "unit", "meaning")
        print_table(f"parameters of '{entry.kind}'", columns, shown_rows)
    if page is not None and page.sets:
        cells = [(key, "must be given" if value == "???" else value) for key, value in page.sets]
        print_line(f"set by {page.file}")
        print_table("", ("name", "value"), cells)
    if recorded:
        print_table("channels that it records", ("name", "unit", "meaning"), recorded)

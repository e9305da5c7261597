"""What every verb prints with: one line, one table, one JSON value, one progress bar.

Results go to stdout, progress to stderr. Colour follows the terminal and NO_COLOR.
"""

from __future__ import annotations

import sys
import time
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from io import StringIO
from typing import Any

PIPE_WIDTH = 1000
"""Characters a table may be wide where no terminal sets a limit, so that nothing is cut."""

PLAIN_INTERVAL_S = 5.0
"""Seconds between two progress lines where no terminal can redraw one."""

Advance = Callable[..., None]
"""Tells progress that `n` (default 1) more are done."""


def print_line(text: str) -> None:
    """Print one line to stdout, as it is."""
    print(text)


def print_json(value: Any) -> None:
    """Print a value as indented JSON: plain values, models, dataclasses, paths, arrays.

    Not-a-number and infinity become null, which every JSON reader accepts.
    """
    from pydantic_core import to_json

    encoded = to_json(value, indent=2, inf_nan_mode="null", fallback=_plain_value)
    print(encoded.decode())


def print_table(title: str, columns: Sequence[str], rows: Iterable[Sequence[object]]) -> None:
    """Print rows under column names; numbers stand to the right, None is a dash."""
    from rich import box
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    cells = [tuple(row) for row in rows]
    table = Table(title=Text(title), title_justify="left", title_style="bold", box=box.SIMPLE_HEAD)
    for index, column in enumerate(columns):
        given = [row[index] for row in cells if row[index] is not None]
        numeric = bool(given) and all(_is_number(value) for value in given)
        table.add_column(Text(column), justify="right" if numeric else "left")
    for row in cells:
        table.add_row(*(Text(_cell(value)) for value in row))
    if sys.stdout.isatty():
        Console(highlight=False).print(table)
        return
    piped = Console(file=StringIO(), width=PIPE_WIDTH, highlight=False)
    with piped.capture() as drawn:
        piped.print(table)
    print("\n".join(line.rstrip() for line in drawn.get().splitlines()))


@contextmanager
def progress(description: str, total: float) -> Iterator[Advance]:
    """Show on stderr how much of `total` is done, the time elapsed and the time remaining.

    Yields `advance(n=1)`. Without a terminal it writes a plain line every few seconds.
    """
    if sys.stderr.isatty():
        with _drawn_progress(description, total) as advance:
            yield advance
    else:
        yield _plain_progress(description, total)


@contextmanager
def _drawn_progress(description: str, total: float) -> Iterator[Advance]:
    from rich.console import Console
    from rich.progress import (
        BarColumn,
        MofNCompleteColumn,
        Progress,
        TextColumn,
        TimeElapsedColumn,
        TimeRemainingColumn,
    )

    columns = (
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        TextColumn("elapsed,"),
        TimeRemainingColumn(),
        TextColumn("remaining"),
    )
    with Progress(*columns, console=Console(stderr=True)) as bar:
        task = bar.add_task(description, total=total)

        def advance(n: float = 1) -> None:
            bar.advance(task, n)

        yield advance


def _plain_progress(description: str, total: float) -> Advance:
    began = time.monotonic()
    said = began
    done = 0.0

    def advance(n: float = 1) -> None:
        nonlocal done, said
        done += n
        now = time.monotonic()
        if now - said < PLAIN_INTERVAL_S and (done < total or said == began):
            return
        said = now
        remaining = (now - began) * max(total - done, 0.0) / done if done > 0 else 0.0
        print(
            f"{description}: {done:g} of {total:g}, {now - began:.0f} s elapsed, "
            f"about {remaining:.0f} s remaining",
            file=sys.stderr,
            flush=True,
        )

    return advance


def _is_number(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _cell(value: object) -> str:
    if value is None:
        return "-"
    if isinstance(value, bool):
        return "yes" if value else "no"
    if isinstance(value, float):
        return f"{value:.6g}"
    return str(value)


def _plain_value(value: Any) -> Any:
    if hasattr(value, "tolist"):
        return value.tolist()
    return str(value)

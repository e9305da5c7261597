"""Pages as one HTML text each, with everything they need inside."""

from __future__ import annotations

import os
from collections.abc import Sequence
from html import escape
from importlib.resources import files
from pathlib import Path
from string import Template
from typing import Literal

from pydantic_core import to_json

from omnistudy.errors.view import NoFolderForPage, PageExists
from omnistudy.version import VERSION
from omnistudy.view.film import Film
from omnistudy.view.trials import TrialList

GENERATOR = "omnistudy replay"
MARK = f'name="generator" content="{GENERATOR}'
HEAD = 4096
"""Bytes in which a page of ours shows its mark."""


def replay_page(films: Sequence[Film]) -> str:
    """Give the page that shows films side by side, in step; the same films give the same text."""
    numbers = " and ".join(str(film.trial) for film in films)
    title = f"{films[0].study}, trial {numbers}"
    return page_text("replay", title, [film.model_dump() for film in films])


def trials_page(trials: TrialList) -> str:
    """Give the page that lists a study's trials."""
    return page_text("trials", trials.study, trials.model_dump())


def live_page(kind: Literal["participant", "monitor"], title: str, content: object) -> str:
    """Give a page of a live trial."""
    return page_text(kind, title, content)


def saying_page(title: str, text: str) -> str:
    """Give a page that has only something to say."""
    return page_text("saying", title, {"title": title, "text": text})


def page_text(kind: str, title: str, content: object) -> str:
    """Give a page of the browser's side; `kind` says which one `content` is for."""
    here = files("omnistudy.view")
    shown = to_json(content, inf_nan_mode="null").decode()
    return Template((here / "page.html").read_text(encoding="utf-8")).substitute(
        generator=f"{GENERATOR} {VERSION}",
        title=escape(title),
        kind=escape(kind, quote=True),
        style=(here / "built" / "view.css").read_text(encoding="utf-8"),
        content=shown.replace("<", "\\u003c"),
        script=(here / "built" / "view.js").read_text(encoding="utf-8"),
    )


def write_page(text: str, page: Path) -> None:
    """Write a page; an older one there is replaced, any other file refused.

    Raises NoFolderForPage, PageExists; then nothing is written.
    """
    if not page.parent.is_dir():
        raise NoFolderForPage(page)
    if page.exists() and not _is_ours(page):
        raise PageExists(page)
    draft = page.with_name(f".{page.name}.{os.getpid()}.part")
    try:
        draft.write_text(text, encoding="utf-8")
        draft.replace(page)
    finally:
        draft.unlink(missing_ok=True)


def _is_ours(page: Path) -> bool:
    if page.is_dir():
        return False
    with page.open("rb") as file:
        return MARK.encode() in file.read(HEAD)

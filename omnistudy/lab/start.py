"""Start a law, a controller, a world, a protocol or a survey: plan the files, then write them."""

from __future__ import annotations

import os
from collections.abc import Iterator
from importlib.resources import files
from pathlib import Path
from typing import NamedTuple

from jinja2 import Environment, StrictUndefined

from omnistudy.errors.lab import FileInTheWay, LabNotWritten
from omnistudy.lab.names import check_name, class_name
from omnistudy.lab.package import find_package, with_entry_point
from omnistudy.registry.conf import lab_folder

NOUNS = ("law", "controller", "world", "protocol", "survey")
"""What can be started."""

EXAMPLES = {"law": "stiffness: 150", "controller": "gain: 6"}
"""Those that are Python, and so stand in the lab's package: a line that changes a number."""

DEFAULT_FOLDER = "lab"
"""Under the current folder, when nothing names another."""


class NewFile(NamedTuple):
    """One file to be written; `adds` tells that it is there and only a line is added."""

    path: Path
    text: str
    adds: bool = False


class Started(NamedTuple):
    """What starting something writes.

    package : as Python imports it; "" for what is no Python.
    """

    noun: str
    name: str
    folder: Path
    files: tuple[NewFile, ...]
    package: str


def default_folder() -> Path:
    """Give the lab's folder: the one that OMNISTUDY_CONF names, else ./lab.

    Raises NoLabFolder when it is named but not there.
    """
    return lab_folder() or Path(DEFAULT_FOLDER)


def plan_start(noun: str, name: str, folder: Path) -> Started:
    """Give the files that start a thing in a lab's folder, which need not exist yet.

    Raises BadName, TakenName, FileInTheWay, or UnusablePyproject; writes nothing.
    """
    check_name(noun, name, folder if folder.is_dir() else None)
    if noun in EXAMPLES:
        planned = tuple(_kind_files(noun, name, folder))
        package = find_package(folder).name
    else:
        planned, package = tuple(_page_files(noun, name, folder)), ""
    for file in planned:
        if not file.adds and os.path.lexists(file.path):
            raise FileInTheWay(file.path)
    return Started(noun, name, folder, planned, package)


def write_start(started: Started) -> None:
    """Write what was planned, whole or not at all; raises FileInTheWay or LabNotWritten."""
    written: list[Path] = []
    path = started.folder
    try:
        for path, text, adds in started.files:
            path.parent.mkdir(parents=True, exist_ok=True)
            if adds:
                _replace(path, text)
                continue
            with path.open("x", encoding="utf-8", newline="") as file:
                written.append(path)
                file.write(text)
    except OSError as refused:
        for done in written:
            done.unlink()
        if isinstance(refused, FileExistsError):
            raise FileInTheWay(Path(refused.filename)) from refused
        raise LabNotWritten(path, refused.strerror or str(refused)) from refused


def _replace(path: Path, text: str) -> None:
    draft = path.with_name(f".{path.name}.part")
    try:
        draft.write_text(text, encoding="utf-8", newline="")
        draft.replace(path)
    except OSError:
        draft.unlink(missing_ok=True)
        raise


def _kind_files(noun: str, name: str, folder: Path) -> Iterator[NewFile]:
    package = find_package(folder)
    words = {
        "name": name,
        "class_name": class_name(noun, name),
        "package": package.name,
        "noun": noun,
        "example": EXAMPLES[noun],
    }
    if not (package.folder / "__init__.py").is_file():
        yield NewFile(package.folder / "__init__.py", _rendered("package.py", words))
    yield NewFile(package.folder / f"{name}.py", _rendered(f"{noun}.py", words))
    yield NewFile(folder / noun / f"{name}.yaml", _rendered("kind.yaml", words))
    yield NewFile(folder / "tests" / f"test_{name}.py", _rendered(f"test_{noun}.py", words))
    # Last, so that a kind is announced only once its module stands.
    old = package.text
    text = _rendered("pyproject.toml", words) if old is None else old
    target = f"{package.name}.{name}:{words['class_name']}"
    announced = with_entry_point(package.pyproject, text, f"{noun}s", name, target)
    yield NewFile(package.pyproject, announced, adds=old is not None)


def _page_files(noun: str, name: str, folder: Path) -> Iterator[NewFile]:
    words = {"name": name, "title": name.replace("_", " ").capitalize()}
    pages = "protocols" if noun == "protocol" else noun
    yield NewFile(folder / pages / f"{name}.yaml", _rendered(f"{noun}.yaml", words))
    yield NewFile(folder / "tests" / f"test_{noun}_{name}.py", _rendered(f"test_{noun}.py", words))


def _rendered(template: str, words: dict[str, str]) -> str:
    environment = Environment(
        autoescape=False, undefined=StrictUndefined, keep_trailing_newline=True, trim_blocks=True
    )
    text = files("omnistudy.lab").joinpath("templates", f"{template}.j2")
    return environment.from_string(text.read_text(encoding="utf-8")).render(words)

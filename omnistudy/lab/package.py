"""The lab's own Python package: where its modules stand and how a kind is announced."""

from __future__ import annotations

import re
import tomllib
from pathlib import Path
from typing import Any, NamedTuple

from omnistudy.errors.lab import UnusablePyproject


class Package(NamedTuple):
    """A package that is, or will be.

    name : as Python imports it.
    folder : where its modules stand.
    pyproject : its pyproject.toml.
    text : what is in that file; None when there is none yet.
    """

    name: str
    folder: Path
    pyproject: Path
    text: str | None


def find_package(lab: Path) -> Package:
    """Give the package that the lab's pyproject.toml makes, else one named after the folder.

    Raises UnusablePyproject when the file cannot be read, or names nothing to be installed.
    """
    pyproject = lab / "pyproject.toml"
    if not pyproject.is_file():
        name = f"{_identifier(lab.resolve().name)}_parts"
        return Package(name, lab / name, pyproject, None)
    text = _read(pyproject)
    tree = _parsed(pyproject, text)
    project = tree.get("project")
    if not isinstance(project, dict) or not isinstance(project.get("name"), str):
        raise UnusablePyproject(
            pyproject,
            "it has no name under [project], so that nothing can be installed from here",
            "add one, or name another folder with --into",
        )
    name = _announcing(project) or _identifier(project["name"])
    source = lab / "src" if (lab / "src" / name).is_dir() else lab
    if (source / f"{name}.py").is_file():
        raise UnusablePyproject(
            pyproject,
            f"its package '{name}' is the one file {source / name}.py",
            "make it a folder with an __init__.py, or name another folder with --into",
        )
    return Package(name, source / name, pyproject, text)


def with_entry_point(file: Path, text: str, group: str, name: str, target: str) -> str:
    """Give a pyproject.toml's text with one kind more announced, and nothing else changed.

    group : "laws". target : "package.module:Class".

    Raises UnusablePyproject when the name is taken there, or the file's form leaves no place.
    """
    table, line = f"omnistudy.{group}", f'{name} = "{target}"'
    if name in _points(_parsed(file, text), table):
        raise UnusablePyproject(
            file, f"it announces '{name}' in {table} already", "choose another name"
        )
    changed = _inserted(text, table, line, "\r\n" if "\r\n" in text else "\n")
    if not _differ_in(text, changed, table, {name: target}):
        raise UnusablePyproject(
            file,
            "its entry points are not written as tables of their own",
            f'write them as [project.entry-points."{table}"] with lines such as {line}',
        )
    return changed


def _differ_in(old: str, new: str, table: str, more: dict[str, str]) -> bool:
    """Tell whether two texts say the same but for what one table has more."""
    try:
        before, after = tomllib.loads(old), tomllib.loads(new)
    except tomllib.TOMLDecodeError:
        return False
    wanted = _points(before, table) | more
    if _points(after, table) != wanted:
        return False
    before["project"].setdefault("entry-points", {})[table] = wanted
    return before == after


def _points(tree: dict[str, Any], table: str) -> dict[str, str]:
    groups = tree["project"].get("entry-points")
    points = groups.get(table) if isinstance(groups, dict) else None
    return points if isinstance(points, dict) else {}


def _inserted(text: str, table: str, line: str, end: str) -> str:
    lines = text.splitlines(keepends=True)
    header = re.compile(rf"""\s*\[\s*project\s*\.\s*entry-points\s*\.\s*["']{table}["']\s*\]""")
    at = next((index for index, old in enumerate(lines) if header.match(old)), None)
    if at is None:
        gap = "" if not text or text.endswith("\n") else end
        return f'{text}{gap}{end}[project.entry-points."{table}"]{end}{line}{end}'
    last = at
    for index in range(at + 1, len(lines)):
        if lines[index].lstrip().startswith("["):
            break
        if lines[index].strip() and not lines[index].lstrip().startswith("#"):
            last = index
    if not lines[last].endswith("\n"):
        lines[last] += end
    return "".join([*lines[: last + 1], f"{line}{end}", *lines[last + 1 :]])


def _announcing(project: dict[str, Any]) -> str:
    """Give the package that already announces kinds to omnistudy, "" when none does."""
    groups = project.get("entry-points", {})
    for group, points in groups.items() if isinstance(groups, dict) else ():
        if group.startswith("omnistudy.") and isinstance(points, dict):
            for target in points.values():
                return str(target).partition(":")[0].partition(".")[0]
    return ""


def _identifier(text: str) -> str:
    """Make a name that Python can import."""
    word = re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")
    return word if re.match("[a-z]", word) else f"lab_{word}".rstrip("_")


def _read(file: Path) -> str:
    try:
        return file.read_bytes().decode("utf-8")
    except (OSError, UnicodeDecodeError) as fault:
        raise UnusablePyproject(
            file, f"cannot be read as text ({fault})", "mend it, or use another folder with --into"
        ) from fault


def _parsed(file: Path, text: str) -> dict[str, Any]:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as fault:
        raise UnusablePyproject(
            file, f"not readable as TOML ({fault})", "mend it, or use another folder with --into"
        ) from fault

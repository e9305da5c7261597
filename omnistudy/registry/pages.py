"""Single pages of a group, such as conf/world/NAME.yaml: names, files, content."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import yaml

from omnistudy.registry.conf import conf_roots

Broken = Callable[[Path, tuple[str, ...]], Exception]
"""Makes the error of a page with faults, one sentence each."""


def page_names(group: str, lab: Path | None = None) -> tuple[str, ...]:
    """Name every page of a group, in the lab's folder and in ours."""
    pages = (page for root in conf_roots(lab) for page in (root / group).glob("*.yaml"))
    return tuple(sorted({page.stem for page in pages}))


def page_file(group: str, name_or_file: str | Path, lab: Path | None = None) -> Path | None:
    """Give a page: a file that exists, else a name in the group, the lab's folder first."""
    if Path(name_or_file).is_file():
        return Path(name_or_file)
    pages = (root / group / f"{name_or_file}.yaml" for root in conf_roots(lab))
    return next((page for page in pages if page.is_file()), None)


def page_content(page: Path, broken: Broken) -> Any:
    """Read a page; raises what `broken` makes when it is not readable as YAML."""
    try:
        return yaml.safe_load(page.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError) as cause:
        mark = getattr(cause, "problem_mark", None)
        line = f", line {mark.line + 1}" if mark else ""
        problem = getattr(cause, "problem", None) or str(cause).splitlines()[0]
        raise broken(page, (f"{page}{line}: not readable as YAML ({problem})",)) from cause

"""Where YAML pages are looked for: the lab's own folder first, then ours."""

from __future__ import annotations

import os
from pathlib import Path

from omnistudy.errors import NoLabFolder

PACKAGE = Path(__file__).resolve().parent.parent
LAB_VARIABLE = "OMNISTUDY_CONF"
"""Environment variable that names the lab's folder when `--conf` is not given."""


def lab_folder(lab: Path | None = None) -> Path | None:
    """Give the lab's folder: the argument, else OMNISTUDY_CONF, else none.

    Raises NoLabFolder when it is named but not there.
    """
    named = str(lab) if lab is not None else os.environ.get(LAB_VARIABLE, "")
    if not named:
        return None
    folder = Path(named).expanduser().resolve()
    if not folder.is_dir():
        raise NoLabFolder(folder, "--conf" if lab is not None else LAB_VARIABLE)
    return folder


def conf_roots(lab: Path | None = None) -> tuple[Path, ...]:
    """Give the folders that hold groups (law, world, ...), the first to be asked first."""
    own = lab_folder(lab)
    ours = _packed() or _checkout() / "conf"
    return (own, ours) if own else (ours,)


def protocol_roots(lab: Path | None = None) -> tuple[Path, ...]:
    """Give the folders that hold whole protocols, the first to be asked first."""
    own = lab_folder(lab)
    packed = _packed()
    ours = packed / "protocols" if packed else _checkout() / "protocols"
    return (own / "protocols", own, ours) if own else (ours,)


def _packed() -> Path | None:
    folder = PACKAGE / "_conf"
    return folder if folder.is_dir() else None


def _checkout() -> Path:
    return PACKAGE.parent

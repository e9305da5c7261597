"""What to type once something has been started."""

from __future__ import annotations

import os
from importlib.util import find_spec
from pathlib import Path
from shlex import quote

from omnistudy.lab.start import Started
from omnistudy.registry.conf import LAB_VARIABLE

_VERBS = {
    "law": ("law show {name}", "law draw {name} -o {name}.svg"),
    "controller": ("controller show {name}",),
    "world": ("world check {name}", "world draw {name} -o {name}.svg"),
    "protocol": ("protocol check {name}", "study create {name}"),
    "survey": ("survey show {name}",),
}


def next_steps(started: Started) -> tuple[str, ...]:
    """Give the commands that install what is Python, run its tests, and show it."""
    folder = quote(str(started.folder))
    wanted = [f"--editable {folder}"] if started.package else []
    if find_spec("pytest") is None:
        wanted.append("pytest")
    named = os.environ.get(LAB_VARIABLE)
    known = named is not None and Path(named).resolve() == started.folder.resolve()
    return (
        *([f"pip install {' '.join(wanted)}"] if wanted else []),
        *([] if known else [f"export {LAB_VARIABLE}={folder}"]),
        f"pytest {folder}",
        *(f"omnistudy {verb.format(name=started.name)}" for verb in _VERBS[started.noun]),
    )

"""From what people type to a study's file: a name in the folder of studies, or a path."""

from __future__ import annotations

import os
from pathlib import Path

from omnistudy.errors.study import BadStudyName, UnknownStudy

STUDIES_VARIABLE = "OMNISTUDY_STUDIES"
"""Environment variable that names the folder of studies."""


def studies_folder() -> Path:
    """Give the folder of studies: OMNISTUDY_STUDIES, else ./studies."""
    return Path(os.environ.get(STUDIES_VARIABLE) or "studies").expanduser()


def study_files() -> dict[str, Path]:
    """Name every study in the folder of studies, with its file."""
    return {path.stem: path for path in sorted(studies_folder().glob("[!.]*.db"))}


def resolve_study(text: str) -> Path:
    """Give the file of a study by name or path; raises UnknownStudy with the nearest name."""
    if looks_like_path(text):
        if Path(text).is_file():
            return Path(text)
    elif text in (files := study_files()):
        return files[text]
    raise UnknownStudy(text, studies_folder(), study_files())


def new_study_file(text: str) -> Path:
    """Give the file that a new study of this name or path will have; raises BadStudyName."""
    path = Path(text) if looks_like_path(text) else studies_folder() / f"{text}.db"
    if path.suffix != ".db" or not path.stem:
        raise BadStudyName(text)
    return path


def looks_like_path(text: str) -> bool:
    """Tell a path from a name."""
    return text.endswith(".db") or "/" in text or os.sep in text

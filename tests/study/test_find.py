from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.study import BadStudyName, UnknownStudy
from omnistudy.study import new_study_file, resolve_study, studies_folder, study_files


def test_a_name_stands_for_a_file_in_the_folder_of_studies(studies: Path) -> None:
    studies.mkdir()
    (studies / "first.db").touch()
    assert resolve_study("first") == studies / "first.db"
    assert study_files() == {"first": studies / "first.db"}


def test_a_path_stands_for_itself(studies: Path, tmp_path: Path) -> None:
    (tmp_path / "elsewhere.db").touch()
    assert resolve_study(str(tmp_path / "elsewhere.db")) == tmp_path / "elsewhere.db"


@pytest.mark.parametrize("given", ["frst", "frst.db", "there/frst.db"])
def test_an_unknown_study_is_answered_with_what_there_is(studies: Path, given: str) -> None:
    studies.mkdir()
    (studies / "first.db").touch()
    with pytest.raises(UnknownStudy, match=r"the studies in .* are first"):
        resolve_study(given)


def test_the_nearest_name_is_offered(studies: Path) -> None:
    studies.mkdir()
    (studies / "first.db").touch()
    with pytest.raises(UnknownStudy, match="did you mean 'first'"):
        resolve_study("frst")


def test_without_any_study_the_answer_says_so(studies: Path) -> None:
    with pytest.raises(UnknownStudy, match="are none yet"):
        resolve_study("first")


def test_the_folder_is_studies_unless_told_otherwise(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OMNISTUDY_STUDIES", raising=False)
    assert studies_folder() == Path("studies")


def test_drafts_are_no_studies(studies: Path) -> None:
    studies.mkdir()
    (studies / ".first.db").touch()
    assert study_files() == {}


def test_a_new_study_is_a_name_or_a_path(studies: Path) -> None:
    assert new_study_file("first") == studies / "first.db"
    assert new_study_file("there/first.db") == Path("there/first.db")
    with pytest.raises(BadStudyName):
        new_study_file("there/first")

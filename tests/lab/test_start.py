"""What starting something plans and writes: whole or not at all, never over a file."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors import NoLabFolder
from omnistudy.errors.lab import BadName, FileInTheWay, LabNotWritten, TakenName
from omnistudy.lab import NOUNS, default_folder, next_steps, plan_start, write_start

WRITTEN = {
    "law": [
        "lab_parts/__init__.py",
        "lab_parts/grip.py",
        "law/grip.yaml",
        "tests/test_grip.py",
        "pyproject.toml",
    ],
    "controller": [
        "lab_parts/__init__.py",
        "lab_parts/grip.py",
        "controller/grip.yaml",
        "tests/test_grip.py",
        "pyproject.toml",
    ],
    "world": ["world/grip.yaml", "tests/test_world_grip.py"],
    "protocol": ["protocols/grip.yaml", "tests/test_protocol_grip.py"],
    "survey": ["survey/grip.yaml", "tests/test_survey_grip.py"],
}


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder that is not there yet."""
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)
    return tmp_path / "lab"


def contents(folder: Path) -> dict[str, bytes]:
    """Give every file under a folder with its bytes."""
    files = (path for path in folder.rglob("*") if path.is_file())
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


@pytest.mark.parametrize("noun", NOUNS)
def test_a_plan_names_every_file_and_writes_none(lab: Path, noun: str) -> None:
    started = plan_start(noun, "grip", lab)
    assert [str(file.path.relative_to(lab)) for file in started.files] == WRITTEN[noun]
    assert not lab.exists()


@pytest.mark.slow
@given(st.sampled_from(NOUNS), st.from_regex(r"[a-z][a-z0-9_]{0,59}", fullmatch=True))
def test_any_name_gives_python_that_parses_and_pages_that_say_it(noun: str, name: str) -> None:
    try:
        started = plan_start(noun, name, Path("nowhere") / "lab")
    except (BadName, TakenName):
        return
    for path, text, _ in started.files:
        if path.suffix == ".py":
            ast.parse(text)
        elif path.suffix == ".yaml":
            page = yaml.safe_load(text)
            assert page["kind" if noun in {"law", "controller"} else "name"] == name


@pytest.mark.parametrize("noun", NOUNS)
def test_what_is_written_is_what_was_planned(lab: Path, noun: str) -> None:
    started = plan_start(noun, "grip", lab)
    write_start(started)
    planned = {str(file.path.relative_to(lab)): file.text.encode() for file in started.files}
    assert contents(lab) == planned
    assert all(text.endswith(b"\n") and not text.endswith(b"\n\n") for text in planned.values())


def test_all_of_them_live_in_one_lab(lab: Path) -> None:
    for noun in NOUNS:
        write_start(plan_start(noun, f"my_{noun}", lab))
    assert len(contents(lab)) == 5 + 3 + 2 + 2 + 2


def test_a_second_law_adds_one_line_and_touches_nothing_else(lab: Path) -> None:
    write_start(plan_start("law", "grip", lab))
    before = contents(lab)
    second = plan_start("law", "soft", lab)
    assert [file.path.name for file in second.files if file.adds] == ["pyproject.toml"]
    write_start(second)
    after = contents(lab)
    pyproject = after.pop("pyproject.toml").decode().splitlines()
    old = before.pop("pyproject.toml").decode().splitlines()
    assert [line for line in pyproject if line not in old] == ['soft = "lab_parts.soft:SoftLaw"']
    assert [line for line in pyproject if line in old] == old
    assert before.items() <= after.items()
    assert set(after) - set(before) == {"lab_parts/soft.py", "law/soft.yaml", "tests/test_soft.py"}


@pytest.mark.parametrize("noun", NOUNS)
def test_the_same_again_is_refused(lab: Path, noun: str) -> None:
    write_start(plan_start(noun, "grip", lab))
    before = contents(lab)
    with pytest.raises(TakenName):
        plan_start(noun, "grip", lab)
    assert contents(lab) == before


def test_a_controller_and_a_law_of_one_name_would_share_a_module(lab: Path) -> None:
    write_start(plan_start("law", "grip", lab))
    with pytest.raises(FileInTheWay, match=r"grip\.py is there already"):
        plan_start("controller", "grip", lab)


@pytest.mark.parametrize("broken_link", [False, True])
def test_a_file_in_the_way_is_never_overwritten(lab: Path, broken_link: bool) -> None:
    way = lab / "tests" / "test_world_grip.py"
    way.parent.mkdir(parents=True)
    if broken_link:
        way.symlink_to(lab / "nowhere")
    else:
        way.write_text("mine")
    with pytest.raises(FileInTheWay, match="test_world_grip"):
        plan_start("world", "grip", lab)


def test_a_file_that_comes_between_plan_and_writing_takes_back_the_rest(lab: Path) -> None:
    started = plan_start("law", "grip", lab)
    (lab / "tests").mkdir(parents=True)
    (lab / "tests" / "test_grip.py").write_text("mine")
    with pytest.raises(FileInTheWay):
        write_start(started)
    assert contents(lab) == {"tests/test_grip.py": b"mine"}


def test_a_file_where_a_folder_should_be_is_one_sentence(lab: Path) -> None:
    lab.mkdir()
    (lab / "tests").write_text("mine")
    with pytest.raises(FileInTheWay, match="tests is there already"):
        write_start(plan_start("world", "grip", lab))
    assert contents(lab) == {"tests": b"mine"}


def test_a_folder_under_a_file_is_one_sentence(tmp_path: Path, lab: Path) -> None:
    (tmp_path / "file").write_text("mine")
    with pytest.raises(LabNotWritten, match="Not a directory"):
        write_start(plan_start("world", "grip", tmp_path / "file" / "lab"))


def test_the_folder_is_that_of_the_environment_else_lab(
    lab: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert default_folder() == Path("lab")
    monkeypatch.setenv("OMNISTUDY_CONF", str(tmp_path))
    assert default_folder() == tmp_path
    monkeypatch.setenv("OMNISTUDY_CONF", str(lab))
    with pytest.raises(NoLabFolder):
        default_folder()


def test_what_comes_next_is_what_there_is_to_type(
    lab: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert next_steps(plan_start("law", "grip", lab)) == (
        f"pip install --editable {lab}",
        f"export OMNISTUDY_CONF={lab}",
        f"pytest {lab}",
        "omnistudy law show grip",
        "omnistudy law draw grip -o grip.svg",
    )
    lab.mkdir()
    monkeypatch.setenv("OMNISTUDY_CONF", str(lab))
    assert next_steps(plan_start("world", "grip", lab))[0] == f"pytest {lab}"


def test_a_folder_with_a_blank_can_be_typed(tmp_path: Path, lab: Path) -> None:
    steps = next_steps(plan_start("law", "grip", tmp_path / "our lab"))
    assert steps[0] == f"pip install --editable '{tmp_path}/our lab'"

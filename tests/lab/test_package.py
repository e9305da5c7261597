"""The lab's package: where it stands, and how a kind is announced in a pyproject.toml."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.errors.lab import UnusablePyproject
from omnistudy.lab.package import find_package, with_entry_point

FILE = Path("pyproject.toml")
HEAD = '[project]\nname = "our-lab"  # as it is installed\nversion = "1"\n'
LAWS = '\n[project.entry-points."omnistudy.laws"]\nold = "our_lab.old:OldLaw"\n'
TOOLS = "\n[tool.ruff]\nline-length = 90\n"


def added(text: str) -> str:
    return with_entry_point(FILE, text, "laws", "grip", "our_lab.grip:GripLaw")


@pytest.mark.parametrize(
    ("before", "after"),
    [
        (
            HEAD,
            HEAD + '\n[project.entry-points."omnistudy.laws"]\ngrip = "our_lab.grip:GripLaw"\n',
        ),
        (HEAD + LAWS, HEAD + LAWS + 'grip = "our_lab.grip:GripLaw"\n'),
        (HEAD + LAWS + TOOLS, HEAD + LAWS + 'grip = "our_lab.grip:GripLaw"\n' + TOOLS),
        (
            HEAD + LAWS + "# a comment of the next table\n" + TOOLS,
            HEAD
            + LAWS
            + 'grip = "our_lab.grip:GripLaw"\n'
            + "# a comment of the next table\n"
            + TOOLS,
        ),
        (
            HEAD + LAWS.rstrip("\n"),
            HEAD + LAWS + 'grip = "our_lab.grip:GripLaw"\n',
        ),
        (
            HEAD.rstrip("\n"),
            HEAD + '\n[project.entry-points."omnistudy.laws"]\ngrip = "our_lab.grip:GripLaw"\n',
        ),
        (
            HEAD + LAWS.replace('"omnistudy.laws"', "'omnistudy.laws'"),
            HEAD
            + LAWS.replace('"omnistudy.laws"', "'omnistudy.laws'")
            + 'grip = "our_lab.grip:GripLaw"\n',
        ),
        (
            (HEAD + LAWS + TOOLS).replace("\n", "\r\n"),
            (HEAD + LAWS + 'grip = "our_lab.grip:GripLaw"\n' + TOOLS).replace("\n", "\r\n"),
        ),
    ],
    ids=[
        "no table", "at the end", "before another table", "before a comment", "no last newline",
        "no table and no last newline", "other quotes", "other line ends",
    ],
)  # fmt: skip
def test_one_line_is_added_and_every_other_byte_stays(before: str, after: str) -> None:
    assert added(before) == after


@given(
    st.lists(st.sampled_from([LAWS, TOOLS, "\n# words\n", "\n\n"]), unique=True),
    st.booleans(),
)
def test_what_is_added_is_the_kind_alone(parts: list[str], ends: bool) -> None:
    text = HEAD + "".join(parts)
    text = text if ends else text.rstrip("\n")
    before, after = tomllib.loads(text), tomllib.loads(added(text))
    assert after["project"]["entry-points"]["omnistudy.laws"].pop("grip") == "our_lab.grip:GripLaw"
    before["project"].setdefault("entry-points", {}).setdefault("omnistudy.laws", {})
    assert after == before


def test_a_kind_that_is_announced_already_is_refused() -> None:
    with pytest.raises(UnusablePyproject, match=r"announces 'old' in .* already"):
        with_entry_point(FILE, HEAD + LAWS, "laws", "old", "our_lab.old:Other")


@pytest.mark.parametrize(
    "form",
    [
        'entry-points."omnistudy.laws".old = "our_lab.old:OldLaw"\n',
        'entry-points = {"omnistudy.laws" = {old = "our_lab.old:OldLaw"}}\n',
        "entry-points = 3\n",
        '\n[project.entry-points]\n"omnistudy.laws" = {old = "our_lab.old:OldLaw"}\n',
    ],
)
def test_tables_of_another_form_are_left_to_their_owner(form: str) -> None:
    with pytest.raises(UnusablePyproject, match=r'write them as \[project\.entry-points\."omni'):
        added(HEAD + form)


def test_a_new_package_is_named_after_the_folder(tmp_path: Path) -> None:
    lab = tmp_path / "Our Lab-2"
    found = find_package(lab)
    assert (found.name, found.folder) == ("our_lab_2_parts", lab / "our_lab_2_parts")
    assert found.text is None


@pytest.mark.parametrize("folder", ["2024", "ÄÖ", "___"])
def test_any_folder_gives_a_name_that_python_can_import(tmp_path: Path, folder: str) -> None:
    name = find_package(tmp_path / folder).name
    assert name.isidentifier()
    assert name.endswith("_parts")


@pytest.mark.parametrize(
    ("text", "made", "package", "folder"),
    [
        (HEAD, (), "our_lab", "our_lab"),
        (HEAD, ("src/our_lab",), "our_lab", "src/our_lab"),
        (HEAD + LAWS.replace("our_lab.old", "other.inside.old"), (), "other", "other"),
        (HEAD + LAWS.replace("our_lab.old", "one_file"), ("one_file",), "one_file", "one_file"),
    ],
    ids=["project's name", "source folder", "what announces already", "a package's own file"],
)
def test_an_existing_package_is_gone_on_with(
    tmp_path: Path, text: str, made: tuple[str, ...], package: str, folder: str
) -> None:
    (tmp_path / "pyproject.toml").write_text(text)
    for name in made:
        (tmp_path / name).mkdir(parents=True)
    found = find_package(tmp_path)
    assert (found.name, found.folder, found.text) == (package, tmp_path / folder, text)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[tool.ruff]\n", r"no name under \[project\]"),
        ("project = 3\n", r"no name under \[project\]"),
        ("[project\n", "not readable as TOML"),
    ],
)
def test_a_pyproject_that_makes_no_package_is_refused(tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / "pyproject.toml").write_text(text)
    with pytest.raises(UnusablePyproject, match=said):
        find_package(tmp_path)


def test_a_pyproject_that_is_no_text_is_refused(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_bytes(b"\xff\xfe[")
    with pytest.raises(UnusablePyproject, match="cannot be read as text"):
        find_package(tmp_path)


def test_a_package_of_one_file_has_no_place_for_another(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_text(HEAD)
    (tmp_path / "our_lab.py").write_text("")
    with pytest.raises(UnusablePyproject, match=r"the one file .*our_lab\.py"):
        find_package(tmp_path)

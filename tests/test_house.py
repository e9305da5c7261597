"""The house rules that a machine can see, over every committed file."""

from __future__ import annotations

import ast
import re
import subprocess
import tomllib
from collections.abc import Callable, Iterator
from importlib.metadata import PackageNotFoundError, distribution
from pathlib import Path

import pytest
from packaging.requirements import Requirement

ROOT = Path(__file__).resolve().parent.parent
LONGEST = 400
"""Lines; past this a file surely says more than one thing."""

WRITTEN_BY_HAND = {".py", ".md", ".yaml", ".toml", ".js", ".ts", ".css", ".html", ".j2"}
WRITTEN_BY_PROGRAMS = {"reference", "built"}
"""Folders whose files nobody edits."""
FORBIDDEN = tuple(
    re.compile(left + right)
    for left, right in (
        ("/wor", "k/"),
        ("/far", "m"),
        (r"\.lib", "rary"),
        ("sub", "agent"),
        (r"/ro", "ot/"),
        ("/opt/", "pypi"),
        (r"extra-index", "-url"),
    )
)
AMERICAN = re.compile(
    r"\b(centers?|centered|randomiz\w+|analyz\w+|behaviors?|colors?|colored|normaliz\w+|"
    r"organiz\w+|neighbors?|serializ\w+|initializ\w+|optimiz\w+|labeled|modeled|favor\w*)\b",
    re.I,
)
COPYLEFT = re.compile(r"\bA?GPL|\bLGPL|GNU (Lesser |Affero )?General Public", re.I)
PERMISSIVE = re.compile(r"MIT|BSD|Apache|ISC|PSF|Python Software|zlib|HPND|Unlicense", re.I)
FILE_BOUND = re.compile(r"MPL|Mozilla", re.I)
"""Copyleft of single files: good enough for a tool that only checks."""


@pytest.fixture(scope="module")
def committed(requires_program: Callable[[str, str], str]) -> list[Path]:
    """Give every text file that git knows of."""
    git = requires_program("git", "git")
    listed = subprocess.run(
        [git, "ls-files", "-z"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    paths = [ROOT / name for name in listed.stdout.split("\0") if name]
    return [path for path in paths if path.is_file() and b"\0" not in path.read_bytes()]


def test_no_file_is_too_long(committed: list[Path]) -> None:
    lengths = {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for path in committed
        if path.suffix in WRITTEN_BY_HAND and path.parent.name not in WRITTEN_BY_PROGRAMS
    }
    assert {name: n for name, n in lengths.items() if n > LONGEST} == {}


def test_no_file_names_a_machine(committed: list[Path]) -> None:
    named = [
        f"{path.relative_to(ROOT)}: {match[0]}"
        for path in committed
        for pattern in FORBIDDEN
        if (match := pattern.search(path.read_text(encoding="utf-8")))
    ]
    assert named == []


def test_spelling_is_british(committed: list[Path]) -> None:
    american = [
        f"{path.relative_to(ROOT)}: {word}"
        for path in committed
        for word in AMERICAN.findall(" ".join(_prose(path)))
    ]
    assert american == []


def _prose(path: Path) -> Iterator[str]:
    """Give the words a person wrote: pages, docstrings and YAML, without code and quoted titles."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".md":
        yield re.sub(r"```.*?```|`[^`]*`|\]\([^)]*\)", "", text, flags=re.S)
    elif path.suffix == ".yaml":
        yield text
    elif path.suffix == ".py":
        for node in ast.walk(ast.parse(text)):
            if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
                yield re.sub(r"``?[^`]*``?|\"[^\"]*\"", "", str(node.value.value))


def _pyproject() -> dict[str, list[str]]:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    return {"run": project["dependencies"], "dev": project["optional-dependencies"]["dev"]}


def _installed_closure(requirements: list[str]) -> set[str]:
    """Give the names of all packages that these requirements bring here, but for ourselves."""
    found: set[tuple[str, str]] = set()
    waiting = [Requirement(text) for text in requirements]
    while waiting:
        requirement = waiting.pop()
        name = _canonical(requirement.name)
        for extra in {"", *requirement.extras} - {extra for one, extra in found if one == name}:
            found.add((name, extra))
            brought = [Requirement(text) for text in distribution(name).requires or []]
            waiting += [r for r in brought if not r.marker or r.marker.evaluate({"extra": extra})]
    return {name for name, _ in found} - {"omnistudy"}


def _licence(name: str) -> str:
    metadata = distribution(name).metadata
    classifiers = [c for c in metadata.get_all("Classifier", []) if c.startswith("License ::")]
    stated = metadata.get("License-Expression") or " ".join(classifiers)
    return stated or str(metadata.get("License", "")).splitlines()[0]


def _canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


def _locked() -> dict[str, set[str]]:
    """Give name -> versions of the lock file."""
    locked: dict[str, set[str]] = {}
    for line in (ROOT / "requirements.lock").read_text(encoding="utf-8").splitlines():
        if pin := re.match(r"([A-Za-z0-9._-]+)==([^ ;]+)", line):
            locked.setdefault(_canonical(pin[1]), set()).add(pin[2])
    return locked


def test_what_runs_has_a_permissive_licence() -> None:
    licences = {name: _licence(name) for name in _installed_closure(_pyproject()["run"])}
    assert {n: text for n, text in licences.items() if not PERMISSIVE.search(text)} == {}
    assert {n: text for n, text in licences.items() if COPYLEFT.search(text)} == {}


def test_what_checks_has_a_free_licence() -> None:
    licences = {name: _licence(name) for name in _installed_closure(_pyproject()["dev"])}
    known = {
        n for n, text in licences.items() if PERMISSIVE.search(text) or FILE_BOUND.search(text)
    }
    assert set(licences) - known == set()


def test_lock_holds_every_package_and_names_no_index() -> None:
    locked = _locked()
    needed = _installed_closure(_pyproject()["run"] + _pyproject()["dev"])
    assert needed <= set(locked), "stale: run `make lock`"
    text = (ROOT / "requirements.lock").read_text(encoding="utf-8")
    assert "://" not in text
    assert "--index" not in text
    pins = text.count("==") - len(re.findall(r"python_full_version ==|sys_platform ==", text))
    assert text.count("--hash=sha256:") >= pins


def test_environment_is_the_lock() -> None:
    differing = {}
    for name, versions in _locked().items():
        try:
            installed = distribution(name).version
        except PackageNotFoundError:
            continue
        if installed not in versions:
            differing[name] = (installed, versions)
    assert differing == {}, "installed differs from requirements.lock: remove .venv, then make test"


def test_package_says_its_licence_and_ships_it() -> None:
    metadata = distribution("omnistudy").metadata
    assert metadata["License-Expression"] == "MIT"
    assert metadata.get_all("License-File") == ["LICENSE"]
    assert (ROOT / "LICENSE").read_text(encoding="utf-8").startswith("MIT License")

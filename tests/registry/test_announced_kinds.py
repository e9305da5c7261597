"""Kinds of installed packages: found by their announcement, and told apart from broken ones."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from omnistudy.errors import BrokenKind
from omnistudy.laws import Law
from omnistudy.registry import kinds, load_kind
from omnistudy.registry.kinds import _announced


@pytest.fixture
def laboratory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """An installed package that announces two laws, one of which is not there."""
    installed = tmp_path / "laboratory-1.0.dist-info"
    installed.mkdir()
    (installed / "METADATA").write_text("Metadata-Version: 2.1\nName: laboratory\nVersion: 1.0\n")
    (installed / "entry_points.txt").write_text(
        "[omnistudy.laws]\n"
        "gentle = laboratory_laws:Gentle\n"
        "lost = laboratory_laws:Lost\n"
        "gone = laboratory_elsewhere:Gone\n"
    )
    (tmp_path / "laboratory_laws.py").write_text(
        "from typing import Literal\n"
        "from omnistudy.laws.none import NoLaw\n"
        "class Gentle(NoLaw):\n"
        "    kind: Literal['gentle'] = 'gentle'\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    _announced.cache_clear()
    yield tmp_path
    _announced.cache_clear()


@pytest.mark.usefixtures("laboratory")
def test_an_announced_law_is_listed_and_loaded() -> None:
    assert {"gentle", "component"} <= set(kinds("laws"))
    gentle = load_kind("laws", "gentle")
    assert issubclass(gentle, Law)
    assert gentle().kind == "gentle"


@pytest.mark.usefixtures("laboratory")
@pytest.mark.parametrize(
    ("kind", "cause"), [("lost", "has no attribute 'Lost'"), ("gone", "laboratory_elsewhere")]
)
def test_what_does_not_load_is_the_packages_fault(kind: str, cause: str) -> None:
    with pytest.raises(BrokenKind, match=rf"'{kind}' in laws.*{cause}.*mend or uninstall"):
        load_kind("laws", kind)

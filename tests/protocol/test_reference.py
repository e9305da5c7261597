from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).resolve().parent.parent.parent


@pytest.fixture(scope="module")
def reference() -> ModuleType:
    path = ROOT / "docs" / "make_protocol_reference.py"
    specification = importlib.util.spec_from_file_location("make_protocol_reference", path)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    return module


def test_the_reference_of_a_protocols_keys_is_fresh(reference: ModuleType) -> None:
    assert reference.PAGE.read_text(encoding="utf-8") == reference.page(), (
        "stale: run `make reference`"
    )


@pytest.mark.parametrize(
    "line",
    [
        "| `conditions.NAME.levels.FACTOR` | text | | at least 1 | required |",
        "| `conditions.NAME.law` | a kind of laws, below |",
        "| `session.longest` | number | s | > 0, <= 3600 | `3600` |",
        "| `site.ethics.status` | `approved` or `not_needed` |",
        "| `boundary (rectangular).layer_x` | number | m |",
    ],
)
def test_keys_come_with_unit_bounds_and_default(reference: ModuleType, line: str) -> None:
    assert line in reference.page()

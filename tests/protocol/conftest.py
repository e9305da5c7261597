from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol


@pytest.fixture(scope="session")
def component() -> Protocol:
    return compose_protocol("utah2017_component")


@pytest.fixture
def lab(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty lab folder, and a working folder of its own beside it."""
    folder = tmp_path / "lab"
    folder.mkdir()
    away = tmp_path / "away"
    away.mkdir()
    monkeypatch.chdir(away)
    monkeypatch.delenv("OMNISTUDY_CONF", raising=False)
    return folder

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol


@pytest.fixture(scope="session")
def component() -> Protocol:
    return compose_protocol("utah2017_component")


@pytest.fixture
def studies(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of studies of the test's own."""
    folder = tmp_path / "studies"
    monkeypatch.setenv("OMNISTUDY_STUDIES", str(folder))
    return folder

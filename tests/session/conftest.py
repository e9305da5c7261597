from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol
from omnistudy.study import create_study

SHORT = (
    "world=primitive_c",
    "routes=[through]",
    "participants.count=2",
    "order.block_length=1",
)
"""The published study in its shortest primitive: two participants, six trials each."""


@pytest.fixture(scope="session")
def short_protocol() -> Protocol:
    return compose_protocol("utah2017_component", SHORT)


@pytest.fixture
def short_study(short_protocol: Protocol, tmp_path: Path) -> Path:
    path = tmp_path / "short.db"
    create_study(short_protocol, path, "short")
    return path

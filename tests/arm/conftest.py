from __future__ import annotations

import pytest

from omnistudy.arm import ArmBody, load_arm


@pytest.fixture(scope="session")
def wmra1() -> ArmBody:
    return ArmBody(load_arm("wmra1"))

"""SYNTHETIC studies for the tests of this folder."""

import pytest
from synthetic_study import Synthetic


@pytest.fixture(scope="session")
def synthetic() -> Synthetic:
    return Synthetic()

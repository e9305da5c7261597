"""The emulated board, for tests that need it."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest
from stick_bench import Bench

from omnistudy.devices.stick.toolchain import missing_packages


@pytest.fixture(scope="session")
def toolchain() -> None:
    """Skip where the emulator cannot be compiled."""
    missing = missing_packages()
    if missing:
        packages = ", ".join(dict.fromkeys(missing.values()))
        pytest.skip(f"needs {', '.join(missing)}: `make system-packages` ({packages})")


@pytest.fixture
def make_bench(toolchain: None) -> Iterator[Callable[[], Bench]]:
    made: list[Bench] = []

    def make() -> Bench:
        made.append(Bench())
        return made[-1]

    yield make
    for bench in made:
        bench.board.close()


@pytest.fixture
def bench(make_bench: Callable[[], Bench]) -> Bench:
    return make_bench()

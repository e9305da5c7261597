"""Compiling on the user's machine: once, into the cache, or one line that says what is missing."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.devices.stick import toolchain as tools
from omnistudy.errors.devices import NoFirmware, NoToolchain, ToolchainFailed


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "omnistudy" / "emulator"


def test_what_is_missing_is_named_with_its_package(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tools.shutil, "which", lambda name: None)
    monkeypatch.setattr(tools, "FILES", {Path("/no/sim_avr.h"): "libsimavr-dev"})
    with pytest.raises(NoToolchain) as refused:
        tools.build()
    assert "avr-gcc" in str(refused.value)
    assert "apt-get install gcc-avr gcc make libsimavr-dev" in str(refused.value)
    assert not cache.exists()


@pytest.mark.usefixtures("toolchain")
def test_the_second_build_is_the_first(cache: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    first = tools.build()
    assert first.firmware.is_file()
    assert first.emulator.is_file()
    assert [path.name for path in cache.iterdir()] == [first.firmware.parent.name]
    monkeypatch.setattr(tools.shutil, "which", lambda name: None)
    assert tools.build() == first


@pytest.mark.usefixtures("toolchain")
def test_sources_that_do_not_compile_are_one_sentence(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("src", "emulator"):
        (tmp_path / "firmware" / name).mkdir(parents=True)
    (tmp_path / "firmware" / "Makefile").write_text("all:\n\t@echo no good >&2; exit 3\n")
    monkeypatch.setattr(tools, "SOURCES", tmp_path / "firmware")
    with pytest.raises(ToolchainFailed, match="no good"):
        tools.build()
    assert list(cache.iterdir()) == []


def test_missing_sources_are_one_sentence(
    cache: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tools, "SOURCES", tmp_path)
    with pytest.raises(NoFirmware, match="install omnistudy anew"):
        tools.build()

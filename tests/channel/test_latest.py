"""A reader finds the latest value whole, whatever the writer is doing."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from omnistudy.channel import LatestValue
from omnistudy.channel.latest import HEADER

WRITER = """
import sys
from pathlib import Path
from omnistudy.channel import LatestValue

with LatestValue(Path(sys.argv[1])) as value:
    for number in range(20_000):
        value.write(bytes([number % 256]) * (number % 900 + 1))
"""


def test_nothing_is_there_before_the_first_value(tmp_path: Path) -> None:
    with LatestValue(tmp_path / "value", 100) as value:
        assert value.read() is None


@given(values=st.lists(st.binary(max_size=64), min_size=1, max_size=8))
def test_the_latest_value_is_read_with_its_number(
    tmp_path_factory: pytest.TempPathFactory, values: list[bytes]
) -> None:
    path = tmp_path_factory.mktemp("latest") / "value"
    with LatestValue(path, 64) as written, LatestValue(path) as read:
        for number, data in enumerate(values, start=1):
            written.write(data)
            assert read.read() == (number, data)
            assert read.read() == (number, data), "reading takes nothing away"


def test_a_value_above_the_capacity_is_refused_and_the_last_one_stays(tmp_path: Path) -> None:
    with LatestValue(tmp_path / "value", 10) as value:
        value.write(b"whole")
        with pytest.raises(ValueError, match="11 bytes"):
            value.write(b"x" * 11)
        assert value.read() == (1, b"whole")


def test_a_reader_beside_a_busy_writer_never_sees_half_a_value(tmp_path: Path) -> None:
    path = tmp_path / "value"
    with (
        LatestValue(path, 1000) as value,
        subprocess.Popen([sys.executable, "-c", WRITER, str(path)]) as process,
    ):
        last = 0
        while process.poll() is None:
            found = value.read()
            if found:
                assert found.number >= last
                last = found.number
                assert found.data == bytes([(found.number - 1) % 256]) * (
                    (found.number - 1) % 900 + 1
                )
        assert process.returncode == 0
        final = value.read()
        assert final is not None
        assert final.number == 20_000


def test_another_sessions_file_is_not_written_into(tmp_path: Path) -> None:
    path = tmp_path / "value"
    with LatestValue(path, 10) as old:
        old.write(b"old")
        with LatestValue(path, 10) as new:
            new.write(b"new")
            assert old.read() == (1, b"old")
            new.remove()
    assert not path.exists()


def test_a_torn_value_is_none(tmp_path: Path) -> None:
    path = tmp_path / "value"
    with LatestValue(path, 10) as value:
        value.write(b"whole")
        torn = path.read_bytes().replace(b"whole", b"whale")
        with path.open("r+b") as file:
            file.write(torn)
        assert value.read() is None
        value.write(b"next")
        assert value.read() == (2, b"next")


def test_a_header_half_written_is_no_value(tmp_path: Path) -> None:
    path = tmp_path / "value"
    with LatestValue(path, 10) as value:
        for data in (b"one", b"two", b"three"):
            value.write(data)
        stored = bytearray(path.read_bytes())
        slot = HEADER.size + (len(stored) - HEADER.size) // 2
        HEADER.pack_into(stored, slot, 1)  # length and checksum are those of "three" already
        HEADER.pack_into(stored, 0, 1)
        path.write_bytes(stored)
        assert value.read() is None

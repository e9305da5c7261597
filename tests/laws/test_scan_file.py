"""Scan files: what a good one gives, and one clear sentence for each bad one."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.laws import BadScanFile
from omnistudy.laws.scan_file import read_scan


def test_a_scan_is_read_as_written(tmp_path: Path) -> None:
    path = tmp_path / "scan.json"
    path.write_text('{"angles": [0, -1.5], "ranges": [0.3, 2], "max_range": 2, "note": "a desk"}')
    scan = read_scan(path)
    assert scan.angles.tolist() == [0.0, -1.5]
    assert scan.ranges.tolist() == [0.3, 2.0]
    assert scan.angles.dtype == scan.ranges.dtype == float
    assert scan.max_range == 2.0
    assert scan.origins is None
    assert scan.rates is None


def test_rays_may_start_off_the_centre_and_tell_how_fast_they_grow(tmp_path: Path) -> None:
    path = tmp_path / "scan.json"
    path.write_text(
        '{"angles": [0, -1.5], "ranges": [0.3, 2], "max_range": 2,'
        ' "x": [0.2, 0], "y": [0.1, -0.2], "rates": [-0.5, 0]}'
    )
    scan = read_scan(path)
    assert scan.origins is not None
    assert scan.origins.tolist() == [[0.2, 0.1], [0.0, -0.2]]
    assert scan.rates is not None
    assert scan.rates.tolist() == [-0.5, 0.0]


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        ("", "is not JSON (line 1"),
        ("angles: [0]", "is not JSON (line 1"),
        ("[" * 100_000, "is nested too deeply"),
        ("[1, 2]", "holds no JSON object"),
        ('{"ranges": [1], "max_range": 2}', "'angles' is missing"),
        ('{"angles": [0], "max_range": 2}', "'ranges' is missing"),
        ('{"angles": [0], "ranges": [1]}', "'max_range' is missing"),
        ('{"angles": [], "ranges": [], "max_range": 2}', "'angles' is empty"),
        ('{"angles": [0, 1], "ranges": [1], "max_range": 2}', "2 angles but 1 ranges"),
        ('{"angles": [0], "ranges": [1], "max_range": 2, "rates": []}', "'rates' is empty"),
        ('{"angles": [0], "ranges": [1], "max_range": 2, "x": [1, 2]}', "1 angles but 2 x"),
        ('{"angles": [0], "ranges": [1], "max_range": 2, "x": [1]}', "'y' is missing"),
        ('{"angles": 0, "ranges": [1], "max_range": 2}', "'angles' must be a list"),
        ('{"angles": [0], "ranges": ["1"], "max_range": 2}', 'entry 0, is "1" and not a number'),
        ('{"angles": [0], "ranges": [null], "max_range": 2}', "is null and not a number"),
        ('{"angles": [true], "ranges": [1], "max_range": 2}', "is true and not a number"),
        ('{"angles": [0], "ranges": [NaN], "max_range": 2}', "'ranges', entry 0, is not finite"),
        ('{"angles": [0], "ranges": [Infinity], "max_range": 2}', "is not finite"),
        ('{"angles": [0], "ranges": [1e999], "max_range": 2}', "is not finite"),
        ('{"angles": [0], "ranges": [1' + "0" * 400 + '], "max_range": 2}', "is not finite"),
        ('{"angles": [0], "ranges": [1], "max_range": 0}', "'max_range' is 0 and must be above"),
        ('{"angles": [0], "ranges": [1], "max_range": "2"}', "'max_range' is \"2\" and not a"),
    ],
)
def test_each_fault_is_named_with_the_file(tmp_path: Path, text: str, fault: str) -> None:
    path = tmp_path / "scan.json"
    path.write_text(text)
    with pytest.raises(BadScanFile) as caught:
        read_scan(path)
    assert fault in str(caught.value)
    assert str(path) in str(caught.value)
    assert "\n" not in str(caught.value)


def test_what_is_no_readable_file_is_named(tmp_path: Path) -> None:
    with pytest.raises(BadScanFile, match="No such file"):
        read_scan(tmp_path / "nowhere.json")
    with pytest.raises(BadScanFile, match="Is a directory"):
        read_scan(tmp_path)
    (tmp_path / "bytes.json").write_bytes(b"\xff\xfe")
    with pytest.raises(BadScanFile, match="is not text"):
        read_scan(tmp_path / "bytes.json")

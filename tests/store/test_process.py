"""Rows reach the study through a process of its own, each once, whoever dies on the way."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest

import omnistudy
from omnistudy.channel import Channel, Ring
from omnistudy.store import StudyWriter
from omnistudy.store.process import Recorder
from omnistudy.store.row_writer import StreamHead

HEAD = StreamHead("stick", 1000, (Channel("angle", "rad", "a count", 0.5), Channel("u", "V", "")))


def until(happened: Callable[[], object]) -> None:
    """Wait for something that must happen, however busy the machine is."""
    end = time.monotonic() + 60.0
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.005)


def fill(ring: Ring, trial: int, first: int, end: int) -> None:
    for row in range(first, end):
        ring.append((trial, row, 0.5 * row, row / 7))


@pytest.fixture
def ring(tmp_path: Path) -> Ring:
    return Ring(tmp_path / "rows", width=4, capacity=10_000)


@pytest.fixture
def running(study: Path) -> Iterator[Path]:
    """Give a study whose first two trials run, held open by its writer as in a session."""
    with StudyWriter.open(study) as writer:
        writer.start_trial(1)
        writer.start_trial(2)
        yield study


@pytest.fixture
def recorder(running: Path, ring: Ring) -> Iterator[Recorder]:
    with Recorder(running, ring.path, HEAD) as made:
        yield made


def stored(study: Path, trial: int) -> np.ndarray:
    with omnistudy.open(study) as opened:
        return opened.stream_record(trial, "stick").data


def expected(rows: range) -> np.ndarray:
    return np.array([(0.5 * row, row / 7) for row in rows])


def test_rows_of_two_trials_become_two_streams(
    running: Path, ring: Ring, recorder: Recorder
) -> None:
    fill(ring, 1, 0, 2500)
    fill(ring, 2, 0, 10)
    assert recorder.settle()
    np.testing.assert_array_equal(stored(running, 1), expected(range(2500)))
    np.testing.assert_array_equal(stored(running, 2), expected(range(10)))
    assert (recorder.rows(1), recorder.rows(2)) == (2500, 10)
    with omnistudy.open(running) as opened:
        assert opened.streams(1)["rate_hz"].item() == 1000.0


def test_a_full_second_is_stored_while_the_trial_runs(
    running: Path, ring: Ring, recorder: Recorder
) -> None:
    fill(ring, 1, 0, 1000)
    until(lambda: recorder.rows(1) == 1000)


@pytest.mark.slow
def test_killed_recorders_lose_nothing_and_store_nothing_twice(
    running: Path, ring: Ring, recorder: Recorder
) -> None:
    def kill() -> None:
        killed = recorder.process_id
        os.kill(killed, signal.SIGKILL)
        until(lambda: recorder.process_id != killed)

    fill(ring, 1, 0, 1500)
    kill()
    fill(ring, 1, 1500, 3000)
    until(lambda: recorder.rows(1) >= 2000)
    kill()
    fill(ring, 1, 3000, 4500)
    kill()
    assert recorder.settle()
    assert recorder.deaths == 3
    np.testing.assert_array_equal(stored(running, 1), expected(range(4500)))


@pytest.mark.slow
def test_rows_that_were_stored_but_not_yet_taken_are_not_stored_again(
    running: Path, ring: Ring
) -> None:
    with Recorder(running, ring.path, HEAD) as first:
        fill(ring, 1, 0, 1200)
        assert first.settle()
    ring.take(0)  # as if it had died between writing and taking
    with Recorder(running, ring.path, HEAD) as second:
        fill(ring, 1, 1200, 1300)
        assert second.settle()
    np.testing.assert_array_equal(stored(running, 1), expected(range(1300)))


def test_a_session_writes_its_study_beside_the_recorder(study: Path, ring: Ring) -> None:
    with StudyWriter.open(study) as writer, Recorder(study, ring.path, HEAD) as recorder:
        for number in range(6):
            fill(ring, 1, 500 * number, 500 * (number + 1))
            writer.start_trial(number + 1)
        assert recorder.settle()
        assert len(writer.interrupted_trials()) == 6
        assert recorder.deaths == 0
    np.testing.assert_array_equal(stored(study, 1), expected(range(3000)))


def test_what_was_overwritten_is_missing_and_the_rest_keeps_its_place(
    running: Path, tmp_path: Path
) -> None:
    ring = Ring(tmp_path / "small", width=4, capacity=100)
    fill(ring, 1, 0, 250)
    with Recorder(running, ring.path, HEAD) as recorder:
        assert recorder.settle()
        assert recorder.rows(1) == 99
    np.testing.assert_array_equal(stored(running, 1), expected(range(151, 250)))


def test_what_waits_is_written_when_the_recorder_is_closed(running: Path, ring: Ring) -> None:
    with Recorder(running, ring.path, HEAD):
        fill(ring, 1, 0, 1234)
    np.testing.assert_array_equal(stored(running, 1), expected(range(1234)))

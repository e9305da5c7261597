"""A process that outlives Ctrl-C, from its first instruction to its last."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess

import pytest

from omnistudy.channel.child import start_child


def answer(asked: Connection) -> None:
    """Answer each question; the module is imported when the child begins."""
    while (question := asked.recv()) is not None:
        asked.send(question + 1)


@pytest.fixture
def child() -> Iterator[tuple[BaseProcess, Connection]]:
    context = get_context("spawn")
    here, there = context.Pipe()
    process = context.Process(target=answer, args=(there,), daemon=True)
    start_child(process)
    there.close()
    try:
        yield process, here
    finally:
        process.terminate()
        process.join()


def test_ctrl_c_while_it_starts_and_while_it_runs(child: tuple[BaseProcess, Connection]) -> None:
    process, line = child
    assert process.pid is not None
    os.kill(process.pid, signal.SIGINT)
    line.send(1)
    assert line.recv() == 2
    os.kill(process.pid, signal.SIGINT)
    line.send(2)
    assert line.recv() == 3
    line.send(None)
    process.join()
    assert process.exitcode == 0


def test_who_started_it_hears_ctrl_c_as_before(child: tuple[BaseProcess, Connection]) -> None:
    with pytest.raises(KeyboardInterrupt):
        signal.raise_signal(signal.SIGINT)

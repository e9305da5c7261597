"""A live session with its pages: the server in a process of its own, the trials in this one."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection
from pathlib import Path
from threading import Thread

from omnistudy.channel import LatestValue
from omnistudy.errors.view import ServerFailed
from omnistudy.store import StoredTrial
from omnistudy.view.live_files import CAPACITY, answer_file, state_file
from omnistudy.view.publisher import Publisher

PATIENCE_S = 60.0
"""How long the server may take to start."""


@dataclass(frozen=True, slots=True)
class Attendance:
    """Where the pages are, and what goes along with each trial."""

    address: str
    accompany: Callable[[StoredTrial], Publisher]


@contextmanager
def attended(study: Path, *, port: int = 0, token: str | None = None) -> Iterator[Attendance]:
    """Serve the pages of a live session meanwhile; what becomes of them never touches a trial.

    Raises AddressTaken, ServerFailed.
    """
    made: list[LatestValue] = []

    def accompany(trial: StoredTrial) -> Publisher:
        if not made:  # only now the study is surely no other session's
            made.extend(LatestValue(file(study), CAPACITY) for file in (state_file, answer_file))
        state, answer = made
        return Publisher(trial.id, state, answer)

    try:
        with _server(study, port, token) as address:
            yield Attendance(address, accompany)
    finally:
        for value in made:
            value.remove()


@contextmanager
def _server(study: Path, port: int, token: str | None) -> Iterator[str]:
    context = get_context("spawn")
    hearing, telling = context.Pipe(duplex=False)
    process = context.Process(target=_serve, args=(study, port, token, telling), daemon=True)
    process.start()
    telling.close()
    try:
        try:
            address = str(hearing.recv()) if hearing.poll(PATIENCE_S) else ""
        except EOFError:
            address = ""
        if not address:
            raise ServerFailed
        yield address
    finally:
        process.terminate()
        process.join()


def _end_with_session() -> None:
    """Leave no server behind, however the session ended."""
    session = parent_process()
    if session is not None:
        session.join()
        os._exit(0)


def _serve(study: Path, port: int, token: str | None, telling: Connection) -> None:
    from omnistudy.view.server import serve

    Thread(target=_end_with_session, daemon=True).start()
    serve(study, port=port, token=token, answering=True, ready=telling.send)

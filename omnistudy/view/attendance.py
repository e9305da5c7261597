"""A live session with its pages: the server in a process of its own, the trials in this one."""

from __future__ import annotations

import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from multiprocessing import get_context, parent_process
from multiprocessing.connection import Connection
from pathlib import Path
from threading import Thread

from omnistudy.channel import LatestValue
from omnistudy.channel.child import start_child
from omnistudy.devices.handheld.keyboard import keys_file
from omnistudy.errors.view import ServerFailed
from omnistudy.store import StoredTrial
from omnistudy.view.live_files import (
    CAPACITY,
    KEYS_CAPACITY,
    answer_file,
    state_file,
)
from omnistudy.view.page_dialogue import PATIENCE_S, Meeting, PageDialogue, Stick
from omnistudy.view.publisher import Publisher, Served

START_S = 60.0
"""How long the server may take to start."""


@dataclass(frozen=True, slots=True)
class Attendance:
    """Where the pages are, what goes along with each trial, and who speaks between two."""

    address: str
    meeting: Meeting

    def accompany(self, trial: StoredTrial, served: Served = lambda: ()) -> Publisher:
        """Give what goes along with a trial; `served` tells how its device serves it."""
        return Publisher(trial.id, *self.meeting(), served)

    def converse(
        self,
        *,
        automatic_s: float | None = None,
        patience_s: float = PATIENCE_S,
        stick: Stick | None = None,
    ) -> PageDialogue:
        """Give who speaks on the participant's page; the parameters are `PageDialogue`'s."""
        return PageDialogue(
            self.meeting, automatic_s=automatic_s, patience_s=patience_s, stick=stick
        )


@contextmanager
def attended(study: Path, *, port: int = 0, token: str | None = None) -> Iterator[Attendance]:
    """Serve the pages of a live session meanwhile; what becomes of them never touches a trial.

    Raises AddressTaken, ServerFailed.
    """
    made: list[LatestValue] = []

    def meeting() -> tuple[LatestValue, LatestValue]:
        if not made:  # only at the first trial the study is surely no other session's
            made.append(LatestValue(state_file(study), CAPACITY))
            made.append(LatestValue(answer_file(study), CAPACITY))
            made.append(LatestValue(keys_file(study), KEYS_CAPACITY))
        return made[0], made[1]

    try:
        with _server(study, port, token) as address:
            yield Attendance(address, meeting)
    finally:
        for value in made:
            value.remove()


@contextmanager
def _server(study: Path, port: int, token: str | None) -> Iterator[str]:
    context = get_context("spawn")
    hearing, telling = context.Pipe(duplex=False)
    process = context.Process(target=_serve, args=(study, port, token, telling), daemon=True)
    start_child(process)
    telling.close()
    try:
        try:
            address = str(hearing.recv()) if hearing.poll(START_S) else ""
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

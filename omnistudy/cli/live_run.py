"""Trials at the wall clock's pace with their pages and devices, for `session run` and `drive`."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from omnistudy.session import RunSummary


def say(sentence: str) -> None:
    """Say something to whoever is there, beside what the command prints."""
    print(sentence, file=sys.stderr, flush=True)


def run_with_pages(
    path: Path,
    *,
    participants: tuple[str, ...] = (),
    limit: int | None = None,
    protocol: str | None = None,
    open_browser: bool = True,
    pauses: bool = True,
    finished: Callable[[], None] = lambda: None,
) -> RunSummary:
    """Run the planned trials one at a time, with the participant's and the experimenter's page.

    Device, recorder and pages are started here, and ended however the run ends. Ctrl-C ends the
    trial, which is stored as aborted, and raises KeyboardInterrupt.

    pauses : lead the participant from trial to trial, with instructions, rests and a countdown.
    """
    import webbrowser

    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.session import run_trials
    from omnistudy.session.held_devices import HeldDevices
    from omnistudy.session.live import run_live
    from omnistudy.session.pauses import pauses_of
    from omnistudy.view.attendance import attended

    with attended(path) as attendance, HeldDevices(path, say) as devices:
        for page in ("participant", "monitor"):
            address = attendance.address.replace("/?", f"/{page}?")
            say(f"{page}: {address}")
            if open_browser:
                webbrowser.open(address)
        led = pauses_of(path, attendance.converse, devices) if pauses else None
        summary = run_trials(
            path,
            participants=participants,
            limit=limit,
            protocol=compose_protocol(protocol) if protocol else None,
            run=lambda ready, specs: run_live(
                ready,
                specs,
                lambda trial: attendance.accompany(trial, devices.measures),
                devices,
                *((led.before,) if led else ()),
            ),
            finished=lambda trial, result: finished(),
        )
        if led:
            led.end()
        return summary

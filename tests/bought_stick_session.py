"""A session with a fake force-feedback stick, in a process that sees it."""

from __future__ import annotations

import os
from itertools import chain, repeat
from pathlib import Path

from fake_system import FakeSystem, Process

from omnistudy.errors import OmnistudyError
from omnistudy.session import run_trials
from omnistudy.session.free_drive import DriveParts, drive_protocol
from omnistudy.session.held_devices import HeldDevices
from omnistudy.session.live import RealTime, run_live
from omnistudy.study import create_study
from omnistudy.tasks.free import FreeTask
from omnistudy.trial import Glimpse

Y = 0x01
DURATION = 1.5


class Person(RealTime):
    """Pushes the stick forward; when told so, stumbles over its cable."""

    stopped = False

    def __init__(self, system: FakeSystem, stumbles: bool, again: str) -> None:
        super().__init__()
        self._system = system
        self._stumbles = stumbles
        self._again = again
        self._pushes = False

    def see(self, glimpse: Glimpse) -> None:
        if not self._pushes:
            self._pushes = True
            self._system.say(f"move {Y} -512")
        if self._stumbles and glimpse.t > 0.5:
            self._stumbles = False
            self._system.say("unplug")

    def end(self, status: str) -> None:
        """Let go, and plug in what was unplugged."""
        self._system.say(self._again)
        self._system.say("plug")


def session(path: Path, again: str) -> tuple[str, list[dict[str, object]]]:
    """Run a study of one trial; in its first attempt the stick is unplugged.

    again : what is told to the fake stick before it is plugged in again. Gives the sentence that
    ended the session, "" for none, and what the stick was told to do.
    """
    parts = DriveParts(world="primitive_c", device="force_stick", law="component")
    protocol = drive_protocol(parts).model_copy(update={"task": FreeTask(duration=DURATION)})
    create_study(protocol, path, "study")
    system = FakeSystem("fake_force_stick.py", "full")
    os.environ.update(system.environment)
    stumbles = chain((True,), repeat(False))
    said = ""
    try:
        with HeldDevices(path) as devices:
            run_trials(
                path,
                run=lambda ready, specs: run_live(
                    ready, specs, lambda trial: Person(system, next(stumbles), again), devices
                ),
            )
    except OmnistudyError as mistake:
        said = str(mistake)
    log = system.say("log")
    system.close()
    return said, log


Process.register("session", session)

"""What a participant meets round the trials of one visit: instructions, rests, thanks."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Protocol

from omnistudy.session.dialogue import Dialogue
from omnistudy.session.held_devices import HeldDevices
from omnistudy.store import StoredTrial, open_study
from omnistudy.study.frozen import frozen_protocol

AUTOMATIC_S = 4.0
"""How long instructions and rests are shown where nobody is there to be waited for (ours)."""


class Pauses:
    """Leads through the trials of one run, which may be of several participants in turn."""

    def __init__(
        self,
        dialogue: Dialogue,
        pause_s: float,
        ready: Callable[[StoredTrial], None] = lambda trial: None,
    ) -> None:
        """Take who is spoken with, and the protocol's pause between two trials in s.

        ready : called ahead of all that is said before a trial, such as to connect the device, by
            which people answer too.
        """
        self._dialogue = dialogue
        self._pause_s = pause_s
        self._ready = ready
        self._session: int | None = None

    def before(self, trial: StoredTrial) -> None:
        """Instruct at a visit's first trial, rest before each other, count down before all."""
        self._ready(trial)
        if trial.session_id != self._session:
            self.end()
            self._session = trial.session_id
            self._dialogue.instruct()
        else:
            self._dialogue.rest(self._pause_s)
        self._dialogue.count_down(trial.id)

    def end(self) -> None:
        """Thank whoever drove last."""
        if self._session is not None:
            self._session = None
            self._dialogue.thank()


Deflection = Callable[[], tuple[float, float, float] | None]


class Converse(Protocol):
    """Gives who speaks with the participant.

    automatic_s : for how long instructions and rests are shown where nobody is waited for.
    stick : where it stands, each axis in parts of its full deflection.
    """

    def __call__(self, *, automatic_s: float | None, stick: Deflection) -> Dialogue:
        """Give the dialogue."""


def pauses_of(study: Path, converse: Converse, devices: HeldDevices) -> Pauses:
    """Give what leads through a study's trials; only people are waited for, no virtual driver.

    The device is connected and checked before the first page, so that it can answer pages.
    """
    with open_study(study) as opened:
        protocol = frozen_protocol(opened.study)

    def ready(trial: StoredTrial) -> None:
        device = protocol.setup_for(trial.condition or "").device
        devices.take(device, protocol.recording.physics_hz)

    automatic_s = None if protocol.driven_by_people else AUTOMATIC_S
    dialogue = converse(automatic_s=automatic_s, stick=devices.deflection)
    return Pauses(dialogue, protocol.session.pause, ready)

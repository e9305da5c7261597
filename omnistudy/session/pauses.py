"""What a participant meets round the trials of one visit: instructions, rests, thanks."""

from __future__ import annotations

from omnistudy.session.dialogue import Dialogue
from omnistudy.store import StoredTrial

AUTOMATIC_S = 4.0
"""How long instructions and rests are shown where nobody is there to be waited for (ours)."""


class Pauses:
    """Leads through the trials of one run, which may be of several participants in turn."""

    def __init__(self, dialogue: Dialogue, pause_s: float) -> None:
        """Take who is spoken with, and the protocol's pause between two trials in s."""
        self._dialogue = dialogue
        self._pause_s = pause_s
        self._session: int | None = None

    def before(self, trial: StoredTrial) -> None:
        """Instruct at a visit's first trial, rest before each other, count down before all."""
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

"""What a session says to the person who takes part, and what it asks."""

from __future__ import annotations

from typing import Protocol

from omnistudy.survey import Answers, ConsentAnswer, ConsentForm, Instrument


class Dialogue(Protocol):
    """Every call returns when the person is done with it; nothing of it reaches a trial.

    Each raises StoppedBetweenTrials when the person wants to end, and NobodyAnswers when nobody
    answers for too long.
    """

    def instruct(self) -> None:
        """Say what is to be done, and wait until the person is ready."""

    def rest(self, seconds: float) -> None:
        """Offer a pause of so many s; who is ready goes on earlier, nobody must."""

    def count_down(self, trial: int) -> None:
        """Count 3, 2, 1 before the trial of that number."""

    def consent(self, form: ConsentForm) -> ConsentAnswer:
        """Show a form and give what the person says to it."""

    def ask(self, instrument: Instrument) -> Answers:
        """Ask every question of an instrument; raises AnswersDoNotFit."""

    def thank(self) -> None:
        """Say that it is over."""

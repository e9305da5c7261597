"""A session's dialogue on the participant's page, by the same files as the trials' states."""

from __future__ import annotations

import json
import secrets
import time
from collections.abc import Callable

from pydantic import BaseModel
from pydantic_core import to_json

from omnistudy.channel import LatestValue
from omnistudy.errors.session import NobodyAnswers, StoppedBetweenTrials
from omnistudy.survey import Answers, ConsentAnswer, ConsentForm, Instrument
from omnistudy.survey.answers import checked
from omnistudy.view.answer import Answer, Said

PATIENCE_S = 3600.0
"""How long a page waits for a person: as long as the longest session (ours)."""
PERIOD_S = 1 / 30
"""How often the page is told again: it shows that the session lives, and where the stick is."""
COUNT_FROM = 3
THANKS_S = 5.0
"""How long thanks are sent; the page keeps them."""

Meeting = Callable[[], tuple[LatestValue, LatestValue]]
Stick = Callable[[], tuple[float, float, float] | None]
"""Where the stick is, in parts of its travel, -1..1: forward, left, anticlockwise; if anywhere."""


class PageDialogue:
    """A `Dialogue` with whoever sits before the participant's page."""

    def __init__(
        self,
        meeting: Meeting,
        *,
        automatic_s: float | None = None,
        patience_s: float = PATIENCE_S,
        stick: Stick | None = None,
    ) -> None:
        """Take the files of state and answer, which are asked for when there is something to say.

        automatic_s : instructions and rests end by themselves after so long, as when nobody is
            there to be waited for. stick : moves through the choices of a page.
        """
        self._meeting = meeting
        self._automatic_s = automatic_s
        self._patience_s = patience_s
        self._stick = stick

    def instruct(self) -> None:
        """Show the instructions."""
        self._converse("instruct", ends_s=self._automatic_s)

    def rest(self, seconds: float) -> None:
        """Show how long the pause still is."""
        ends = None if self._automatic_s is None else min(seconds, self._automatic_s)
        self._converse("rest", lasts_s=seconds if ends is None else ends, ends_s=ends)

    def count_down(self, trial: int) -> None:
        """Count a number a second, while the page makes the trial's world ready."""
        self._converse("countdown", lasts_s=COUNT_FROM, ends_s=COUNT_FROM, trial=trial)

    def consent(self, form: ConsentForm) -> ConsentAnswer:
        """Show a form until it is agreed to or declined."""
        said = self._answered("consent", form)
        ticked = tuple(one.name for one in form.asked if one.name in said.ticked)
        needed = [one.name for one in form.asked if one.required and one.name not in ticked]
        return ConsentAnswer(version=form.version, agreed=said.agreed and not needed, ticked=ticked)

    def ask(self, instrument: Instrument) -> Answers:
        """Show an instrument until it is answered."""
        return checked(instrument, self._answered("survey", instrument).given)

    def thank(self) -> None:
        """Show thanks."""
        self._converse("thank", ends_s=THANKS_S)

    def _answered(self, page: str, content: BaseModel) -> Said:
        said = self._converse(page, content=content)
        if said is None:
            raise NobodyAnswers(page, self._patience_s)
        return said

    def _converse(
        self,
        page: str,
        *,
        lasts_s: float = 0.0,
        ends_s: float | None = None,
        trial: int | None = None,
        content: BaseModel | None = None,
    ) -> Said | None:
        """Show a page until it is answered, or for `ends_s`; None when nobody said anything."""
        state, answer = self._meeting()
        lines = _last_lines(state)
        mark = secrets.token_hex(8)
        began = time.monotonic()
        while True:
            passed = time.monotonic() - began
            shown = {
                "page": page,
                "mark": mark,
                "remaining": max(0.0, lasts_s - passed),
                "trial": trial,
                "content": content,
                "lines": lines,
                "stick": self._stick() if self._stick else None,
            }
            state.write(to_json({"dialogue": shown, "made": time.monotonic()}))
            said = Answer.latest(answer).said
            if said is not None and said.to == mark:
                if said.stopped:
                    raise StoppedBetweenTrials(page)
                return said
            if ends_s is not None and passed >= ends_s:
                return None
            if passed >= self._patience_s:
                raise NobodyAnswers(page, self._patience_s)
            time.sleep(PERIOD_S)


def _last_lines(state: LatestValue) -> list[str]:
    """Give what stood on the screen when the trial before ended: there was no time to read it."""
    found = state.read()
    return list(json.loads(found.data).get("lines", ())) if found else []

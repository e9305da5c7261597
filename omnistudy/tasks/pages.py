"""The sentences of a participant's pages: between trials, consent, questionnaires (all ours)."""

from __future__ import annotations

from typing import Annotated

from pydantic import AfterValidator, Field

from omnistudy.registry import Model

Words = Annotated[str, Field(min_length=1)]


def _holding(*names: str) -> AfterValidator:
    """Refuse a sentence that lost what is filled into it."""

    def check(sentence: str) -> str:
        for name in names:
            if f"{{{name}}}" not in sentence:
                raise ValueError(f"the sentence must hold {{{name}}}, which is filled in")
        return sentence

    return AfterValidator(check)


class PauseWords(Model):
    """Before, between and after the trials."""

    welcome: Words
    """Heading of the instructions."""
    instructions: Annotated[tuple[Words, ...], Field(min_length=1)]
    """What is to be done, one paragraph each."""
    ready: Words
    """On the button that begins, or ends a rest."""
    rest: Words
    """Heading between two trials."""
    rest_left: Annotated[Words, _holding("time")]
    """How long the planned pause still lasts; `{time}` is minutes and seconds."""
    rest_over: Words
    """When the planned pause is over."""
    countdown: Words
    """Above the number that counts down."""
    starting: Words
    """From the end of the countdown until the world is seen."""
    thanks: Words
    """Heading when all is done."""
    thanks_text: Words
    """Below it."""


class ConsentWords(Model):
    """Round a consent form, whose own text belongs to the study."""

    step: Annotated[Words, _holding("number", "total")]
    """Which part of the form is being read."""
    asked: Words
    """Heading of what is asked to be ticked."""
    needed: Words
    """Behind what must be ticked by who agrees."""
    ticks_needed: Words
    """When somebody agrees without it."""
    agree: Words
    decline: Words


class SurveyWords(Model):
    """Round an instrument, whose own questions are the instrument's."""

    step: Annotated[Words, _holding("number", "total")]
    """Which question is being asked."""
    finish: Words
    """On the button after the last question."""
    optional: Words
    """Beside a question that may stay unanswered."""
    no_answer: Words
    """Takes the answer to such a question back."""
    answer_needed: Words
    """When a question that needs an answer has none."""
    number_needed: Words
    """When what was written is no number."""
    whole_number_needed: Words
    """When it is not a whole one."""
    at_least: Annotated[Words, _holding("lowest")]
    """When it is too small."""
    at_most: Annotated[Words, _holding("highest")]
    """When it is too great."""


class ControlWords(Model):
    """On what every page has."""

    next: Words
    back: Words
    read_on: Words
    """Moves a long text on by a screen."""
    full_screen: Words
    pad: Words
    """Name of the letters that are written with one switch or with the stick."""
    letters: Annotated[tuple[Words, ...], Field(min_length=1)]
    """The letters of the language and what else is written, in rows."""
    space: Words
    delete: Words


class Pages(Model):
    """One language's sentences on the pages that are shown between trials."""

    pauses: PauseWords
    consent: ConsentWords
    survey: SurveyWords
    controls: ControlWords

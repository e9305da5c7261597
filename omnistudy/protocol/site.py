"""What may differ from laboratory to laboratory without making it another study."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from omnistudy.registry import Model
from omnistudy.units import Metres, Positive, Radians, Seconds


class Ethics(Model):
    """The approval under which people take part (Tyagi 2017, ch. 5: IRB number on the record)."""

    status: Literal["approved", "not_needed"]
    """`not_needed` only for virtual participants, with the reason in `note`."""
    board: str = ""
    """Who approved it."""
    number: str = ""
    """Number of the approval."""
    note: str = ""
    """Whatever a reader must know about it."""


class FirstPerson(Model):
    """What a participant's screen shows of the world; nothing behind the robot is seen (ours)."""

    height: Annotated[Metres, Positive] = 0.75
    """Of the eye above the floor: just under the walls of 2017."""
    ahead: Metres = -0.1
    """Of the eye before the robot's centre."""
    field_of_view: Annotated[Radians, Field(gt=0.2, lt=2.6)] = 1.22
    """From the lower to the upper edge of the picture."""
    force_arrows: bool = False
    """Draw the law's force on the robot too: feedback for the eye."""


class Scanning(Model):
    """One switch for everything: choices are lit in turn, the switch takes the lit one (ours)."""

    one_switch: bool = False
    """Whether any key, switch or touch takes the choice that is lit."""
    pace: Annotated[Seconds, Field(ge=0.3, le=20.0)] = 1.5
    """How long each choice is lit."""


class Site(Model):
    """Approval, display and access of one laboratory."""

    ethics: Ethics
    display: str = ""
    """What participants look at, in words."""
    first_person: FirstPerson = FirstPerson()
    """How the world is shown to them."""
    scanning: Scanning = Scanning()
    """How those work the pages who can use one switch."""

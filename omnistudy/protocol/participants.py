"""Who takes part, and how long a session may last."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field

from omnistudy.protocol.fields import Name
from omnistudy.registry import Model
from omnistudy.units import Positive, Seconds


class Stratum(Model):
    """Participants who are alike in something that is known before they are allocated."""

    name: Name
    """What the database calls it."""
    count: Annotated[int, Field(ge=1, le=1000)]
    """Slots of the stratum."""


class Participants(Model):
    """How many participants of which kind, and the keys behind virtual participants' draws."""

    kind: Literal["virtual", "human"]
    """Human and virtual participants never meet in one study."""
    count: Annotated[int, Field(ge=1, le=1000)]
    """Slots to be filled."""
    strata: tuple[Stratum, ...] = ()
    """A mapping from the stratum's name to its slots; each is allocated by itself."""
    study_key: str = ""
    """Behind orders and trial seeds of a virtual study; a human study's lies in its vault."""
    participant_key: str = ""
    """Behind the draws that make a virtual person: protocols that share it meet the same people."""


class SessionLimits(Model):
    """Time that one participant gives in one visit."""

    longest: Annotated[Seconds, Positive, Field(le=3600.0)] = 3600.0
    """At most one hour a person (Tyagi 2017, ch. 5)."""
    pause: Annotated[Seconds, Field(ge=0.0)] = 60.0
    """Planned between two trials (ours)."""

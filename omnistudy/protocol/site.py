"""What may differ from laboratory to laboratory without making it another study."""

from __future__ import annotations

from typing import Literal

from omnistudy.registry import Model


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


class Site(Model):
    """Approval and display of one laboratory."""

    ethics: Ethics
    display: str = ""
    """What participants look at, in words."""

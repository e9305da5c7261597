"""Keys held on the participant's page, as a stick that moves at a steady pace."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal, Self

from omnistudy.devices.handheld.axes import AxisMap
from omnistudy.devices.handheld.handheld import Handheld
from omnistudy.devices.handheld.hardware import Hardware
from omnistudy.errors.handheld import NoKeys
from omnistudy.units import Positive, Seconds


def keys_file(study: Path) -> Path:
    """Give the file beside a study in which its server keeps the keys that are held."""
    return study.with_name(f"{study.name}-keys")


class Keyboard(Handheld):
    """Keys held on the participant's page; no force.

    A held key moves the stick out at a steady pace, a released one lets it back. The page's server
    writes what is held, named by the key's place (KeyboardEvent.code), whatever is printed on it.
    """

    kind: Literal["keyboard"] = "keyboard"
    x: AxisMap = AxisMap(axis="ArrowUp", opposite="ArrowDown")
    y: AxisMap = AxisMap(axis="ArrowLeft", opposite="ArrowRight")
    theta: AxisMap = AxisMap(axis="KeyQ", opposite="KeyE")
    out_in: Annotated[Seconds, Positive] = 0.4
    """From rest to full deflection while a key is held (ours)."""
    back_in: Annotated[Seconds, Positive] = 0.15
    """From full deflection to rest once it is released (ours)."""
    stale_after: Annotated[Seconds, Positive] = 0.3
    """Keys that nobody has renewed for so long count as released: a dead page holds none."""
    file: Path | None = None
    """Where the held keys stand; a session of a study fills it in."""

    def at(self, study: Path) -> Self:
        """Give the keyboard of that study's page."""
        return self.model_copy(update={"file": keys_file(study)})

    def reach(self) -> Hardware:
        """Look for the page's keys; raises NoKeys outside a live session."""
        from omnistudy.devices.handheld.held_keys import HeldKeys

        if self.file is None:
            raise NoKeys
        names = [name for one in self.maps for name in (one.axis, one.opposite) if name]
        return HeldKeys(self.file, names, self)

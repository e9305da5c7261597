"""Mistakes in putting a robot into a world."""

from omnistudy.errors.base import OmnistudyError


class StartsInWall(OmnistudyError):
    """A robot that does not fit where the world lets it start."""

    def __init__(self, plant: str, x: float, y: float, walls: tuple[str, ...]) -> None:
        super().__init__(
            f"plant '{plant}' starts at x = {x:g} m, y = {y:g} m inside {', '.join(walls)}: "
            "move the world's start, or the wall"
        )

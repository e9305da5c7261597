"""Mistakes in worlds, their files and their routes."""

from collections.abc import Sequence
from pathlib import Path

from omnistudy.errors.base import OmnistudyError
from omnistudy.errors.registry import nearest


class UnknownRoute(OmnistudyError):
    """A route that the world does not have."""

    def __init__(self, world: str, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"world '{world}' has no route '{given}': its routes are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )


class UnknownWorld(OmnistudyError):
    """A world that is neither a file nor a name in a configuration folder."""

    def __init__(self, given: str, allowed: Sequence[str]) -> None:
        super().__init__(
            f"no world '{given}': there is no such file, and the worlds are {', '.join(allowed)}"
            f"{nearest(given, allowed)}"
        )


class BrokenWorld(OmnistudyError):
    """A world's page that does not say a world; one sentence a fault."""

    def __init__(self, page: Path, faults: Sequence[str]) -> None:
        super().__init__("\n".join(faults))
        self.page = page
        self.faults = tuple(faults)


class BrokenSdf(OmnistudyError):
    """A Gazebo world that cannot be imported."""

    def __init__(self, file: Path, fault: str) -> None:
        super().__init__(
            f"{file}: {fault}; boxes, cylinders, planes and actors in SDF can be imported"
        )


class BrokenMap(OmnistudyError):
    """A map of ROS's map_server that cannot be imported."""

    def __init__(self, file: Path, fault: str) -> None:
        super().__init__(f"{file}: {fault}; a map is a YAML page of map_server and its image")


class NoFreeSpace(OmnistudyError):
    """A map in which there is nowhere to drive."""

    def __init__(self, file: Path, occupied: int, unknown: int) -> None:
        super().__init__(
            f"{file}: no cell is free: {occupied} are occupied and {unknown} unknown; look at "
            "negate and the thresholds, or at the image"
        )


class TooManyBoxes(OmnistudyError):
    """A map of specks that no few boxes can stand for."""

    def __init__(self, file: Path, most: int) -> None:
        super().__init__(
            f"{file}: its occupied cells need more than {most} boxes: is the image a map? Clear it "
            "of specks, cut out what is driven through, or make its cells coarser"
        )


class NoRoute(OmnistudyError):
    """A world that nobody can drive through yet."""

    def __init__(self, world: str) -> None:
        super().__init__(
            f"world '{world}' has no route: add one to its page under `routes`, which leads to a "
            "finish body, or import its map again with --goal X Y"
        )


class NoWay(OmnistudyError):
    """A start and a goal between which there is nothing to drive."""

    def __init__(self, start: Sequence[float], goal: Sequence[float]) -> None:
        super().__init__(
            f"there is no way from the start {_numbers(start)} to the goal {_numbers(goal)}: give "
            "two different places, in m, and a heading in rad"
        )


class BrokenPath(OmnistudyError):
    """A file of path points that cannot be read."""

    def __init__(self, file: Path, fault: str) -> None:
        super().__init__(f"{file}: {fault}; a path is a .npy array or a .csv of rows x, y")


class WorldExists(OmnistudyError):
    """A page that an import would overwrite."""

    def __init__(self, file: Path) -> None:
        super().__init__(f"{file} exists already: give another name, or --force to replace it")


class WorldNotWritten(OmnistudyError):
    """A page that the system does not let be written."""

    def __init__(self, file: Path, reason: str) -> None:
        super().__init__(
            f"{file} cannot be written ({reason}): give a place in a folder that exists"
        )


def _numbers(given: Sequence[float]) -> str:
    return f"({', '.join(f'{number:g}' for number in given)})"

"""Maps as ROS's map_server reads them: a YAML page and an image of what is occupied.

The meaning of pixels is that of nav2_map_server (docs.nav2.org, "Map Server"; `map_io.cpp`). The
older map_server of ROS 1 differs where nobody looks: half transparent pixels in mode `scale`, and
`negate` in mode `raw`.
"""

from __future__ import annotations

import warnings
from math import isfinite
from pathlib import Path
from typing import Any, Literal, NamedTuple

import numpy as np
import yaml
from numpy.typing import NDArray

from omnistudy.errors.worlds import BrokenMap

OCCUPIED, FREE, UNKNOWN = 100, 0, -1
"""Values of cells; mode `scale` and `raw` give values between free and occupied, too."""

LARGEST = 32_000_000
"""Cells that a map may have (ours): 280 m x 280 m at 5 cm."""

Mode = Literal["trinary", "scale", "raw"]
MODES: tuple[Mode, ...] = ("trinary", "scale", "raw")


class MapPage(NamedTuple):
    """What a map's YAML page says.

    resolution : m a pixel. origin : x, y in m and yaw in rad of the image's lower left corner.
    negate : white is occupied. occupied, free : thresholds of occupancy, 0 to 1.
    """

    image: Path
    resolution: float
    origin: tuple[float, float, float]
    negate: bool
    occupied: float
    free: float
    mode: Mode


class OccupancyMap(NamedTuple):
    """A map's page and its cells: int8 (rows, columns), row 0 the lowest; -1, or 0 to 100."""

    page: MapPage
    cells: NDArray[np.int8]


def read_map(file: Path) -> OccupancyMap:
    """Read a map's page and its image; raises BrokenMap, which says what is wrong where."""
    page = read_page(file)
    sums, most, opaque = _brightness(file, page)
    values = meaning(page, np.arange(most + 1) / most)
    cells = values[sums]
    if page.mode == "scale" and opaque is not None:
        cells[~opaque] = UNKNOWN
    return OccupancyMap(page, cells[::-1])


def meaning(page: MapPage, shade: NDArray[np.float64]) -> NDArray[np.int8]:
    """Give the values of cells whose pixels have a brightness from 0 (black) to 1 (white)."""
    if page.mode == "raw":
        values = np.floor(shade * 255.0 + 0.5)
        return np.where(values <= OCCUPIED, values, UNKNOWN).astype(np.int8)
    occupancy = shade if page.negate else 1.0 - shade
    between = np.full(shade.shape, float(UNKNOWN))
    if page.mode == "scale":
        between = np.rint((occupancy - page.free) / (page.occupied - page.free) * 100.0)
    known = np.where(occupancy < page.free, FREE, between)
    return np.where(page.occupied < occupancy, OCCUPIED, known).astype(np.int8)


def read_page(file: Path) -> MapPage:
    """Read a map's YAML page; raises BrokenMap."""
    given = _mapping(file)
    free, occupied = (_number(file, given, f"{what}_thresh") for what in ("free", "occupied"))
    if not 0.0 <= free < occupied <= 1.0:
        raise BrokenMap(
            file,
            f"free_thresh is {free:g} and occupied_thresh {occupied:g}, where 0 <= free_thresh < "
            "occupied_thresh <= 1 is needed",
        )
    resolution = _number(file, given, "resolution")
    if resolution <= 0.0:
        raise BrokenMap(file, f"resolution is {resolution:g}, where metres a pixel are needed")
    origin = given["origin"]
    if not isinstance(origin, list) or len(origin) != 3 or not all(map(_finite, origin)):
        raise BrokenMap(file, f"origin is {origin!r}, where [x, y, yaw] in m and rad is needed")
    mode = given.get("mode", "trinary")
    if mode not in MODES:
        raise BrokenMap(file, f"mode is {mode!r}, where {', '.join(MODES)} are allowed")
    if given["negate"] not in (0, 1):
        raise BrokenMap(file, f"negate is {given['negate']!r}, where 0 or 1 is needed")
    x, y, yaw = (float(number) for number in origin)
    image = file.parent / str(given["image"])
    return MapPage(image, resolution, (x, y, yaw), bool(given["negate"]), occupied, free, mode)


NEEDED = ("image", "resolution", "origin", "negate", "occupied_thresh", "free_thresh")


def _mapping(file: Path) -> dict[str, Any]:
    try:
        given = yaml.safe_load(file.read_text(encoding="utf-8"))
    except FileNotFoundError:
        raise BrokenMap(file, "there is no such file") from None
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as cause:
        raise BrokenMap(file, f"it cannot be read as YAML ({_first_line(cause)})") from cause
    if not isinstance(given, dict):
        raise BrokenMap(file, "it is no map: a mapping with `image` and `resolution` is needed")
    lacking = [name for name in NEEDED if name not in given]
    if lacking:
        raise BrokenMap(file, f"it is no map: {', '.join(lacking)} missing")
    return given


def _number(file: Path, given: dict[str, Any], name: str) -> float:
    if not _finite(given[name]):
        raise BrokenMap(file, f"{name} is {given[name]!r}, where a number is needed")
    return float(given[name])


def _finite(value: object) -> bool:
    return isinstance(value, int | float) and not isinstance(value, bool) and isfinite(value)


def _first_line(cause: Exception) -> str:
    return str(cause).splitlines()[0]


class Brightness(NamedTuple):
    """Sums of a pixel's channels (rows, columns), the sum of a white one, and what is opaque."""

    sums: NDArray[np.int64]
    most: int
    opaque: NDArray[np.bool_] | None


def _brightness(file: Path, page: MapPage) -> Brightness:
    """Add up the channels of each pixel; in mode `trinary` alpha is one of them."""
    from PIL import Image, UnidentifiedImageError

    too_large = (Image.DecompressionBombError, Image.DecompressionBombWarning)
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("error", Image.DecompressionBombWarning)
            image = Image.open(page.image)
        with image:
            if image.width * image.height > LARGEST:
                raise too_large[0]
            return _summed(image, page.mode)
    except FileNotFoundError:
        raise BrokenMap(file, f"there is no image {page.image}") from None
    except too_large:
        raise BrokenMap(
            file,
            f"{page.image.name} has more than {LARGEST} pixels: cut out what is driven through, "
            "or make the pixels coarser",
        ) from None
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError) as cause:
        fault = f"the image {page.image} cannot be read ({_first_line(cause)})"
        raise BrokenMap(file, fault) from cause


def _summed(image: Any, mode: Mode) -> Brightness:
    if image.mode.startswith("I"):
        return Brightness(np.asarray(image, dtype=np.int64), 65535, None)
    alpha = image.mode in ("LA", "PA", "RGBA") or "transparency" in image.info
    pixels = np.asarray(image.convert("RGBA" if alpha else "RGB"))
    counted = pixels if alpha and mode == "trinary" else pixels[..., :3]
    opaque = pixels[..., 3] == 255 if alpha else None
    return Brightness(counted.sum(axis=2, dtype=np.int64), 255 * counted.shape[2], opaque)

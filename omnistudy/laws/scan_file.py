"""A scan as a JSON file."""

from __future__ import annotations

import json
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from omnistudy.errors.laws import BadScanFile
from omnistudy.geometry import Scan


def read_scan(path: Path) -> Scan:
    """Read a scan from JSON with `angles` (rad), `ranges` (m) and `max_range` (m).

    Rays that do not start at the robot's centre have `x` and `y` (m), what a sensor tells of how
    fast its ranges grow stands in `rates` (m/s); other keys are left alone. Raises BadScanFile,
    which says what is wrong.
    """
    content = _content(path)
    angles = _numbers(path, content, "angles")
    ranges = _per_ray(path, content, "ranges", len(angles))
    max_range = _number(path, "'max_range'", _value(path, content, "max_range"))
    if max_range <= 0.0:
        raise BadScanFile(path, f"'max_range' is {max_range:g} and must be above zero")
    origins = rates = None
    if "x" in content or "y" in content:
        places = [_per_ray(path, content, axis, len(angles)) for axis in ("x", "y")]
        origins = np.array(places, np.float64).T
    if "rates" in content:
        rates = np.array(_per_ray(path, content, "rates", len(angles)), np.float64)
    return Scan(
        np.array(angles, np.float64), np.array(ranges, np.float64), max_range, origins, rates
    )


def _content(path: Path) -> dict[str, Any]:
    try:
        content = json.loads(path.read_text(encoding="utf-8"), parse_int=float)
    except OSError as refused:
        raise BadScanFile(path, f"cannot be read ({refused.strerror})") from None
    except UnicodeDecodeError:
        raise BadScanFile(path, "is not text") from None
    except json.JSONDecodeError as fault:
        raise BadScanFile(path, f"is not JSON (line {fault.lineno}: {fault.msg})") from None
    except RecursionError:
        raise BadScanFile(path, "is nested too deeply") from None
    if not isinstance(content, dict):
        raise BadScanFile(path, "holds no JSON object")
    return content


def _value(path: Path, content: dict[str, Any], key: str) -> Any:
    if key not in content:
        raise BadScanFile(path, f"'{key}' is missing")
    return content[key]


def _numbers(path: Path, content: dict[str, Any], key: str) -> list[float]:
    values = _value(path, content, key)
    if not isinstance(values, list):
        raise BadScanFile(path, f"'{key}' must be a list of numbers")
    if not values:
        raise BadScanFile(path, f"'{key}' is empty")
    return [_number(path, f"'{key}', entry {i},", value) for i, value in enumerate(values)]


def _per_ray(path: Path, content: dict[str, Any], key: str, rays: int) -> list[float]:
    values = _numbers(path, content, key)
    if len(values) != rays:
        raise BadScanFile(path, f"{rays} angles but {len(values)} {key}")
    return values


def _number(path: Path, name: str, value: Any) -> float:
    if not isinstance(value, float):
        raise BadScanFile(path, f"{name} is {json.dumps(value)} and not a number")
    if not isfinite(value):
        raise BadScanFile(
            path, f"{name} is not finite; a ray that met nothing holds the value of max_range"
        )
    return value

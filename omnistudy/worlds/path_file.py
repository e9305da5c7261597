"""A way through a world as a file of points."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from omnistudy.errors.worlds import BrokenPath
from omnistudy.worlds.route import Point


def read_path(file: Path, step: float = 1.0, first: Point = (0.0, 0.0)) -> tuple[Point, ...]:
    """Read rows (i, j) from .npy or .csv and give x = step·i + first x, y = step·j + first y, m.

    Raises BrokenPath.
    """
    try:
        if file.suffix == ".npy":
            rows = np.load(file, allow_pickle=False)
        else:
            lines = file.read_text(encoding="utf-8").split("\n")
            rows = np.array([line.split(",") for line in lines if line.strip()], dtype=np.float64)
    except FileNotFoundError:
        raise BrokenPath(file, "there is no such file") from None
    except (OSError, ValueError, EOFError) as cause:
        raise BrokenPath(file, f"it cannot be read as numbers ({cause})") from cause
    if rows.ndim != 2 or rows.shape[1] != 2 or not len(rows):
        raise BrokenPath(file, f"its shape is {rows.shape}, not (rows, 2)")
    if rows.dtype.kind not in "iuf" or not np.isfinite(rows).all():
        raise BrokenPath(file, "it holds something that is no finite number")
    return tuple((step * float(i) + first[0], step * float(j) + first[1]) for i, j in rows)

"""A plan as a picture file: same world, same bytes."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from omnistudy.errors.pictures import PictureExists, PictureNotWritten, UnknownPictureFormat
from omnistudy.worlds.drawing import LABEL_MARGIN, draw_plan, extent
from omnistudy.worlds.world import World

METADATA: dict[str, dict[str, Any]] = {
    ".svg": {"Date": None, "Creator": None},
    ".png": {"Software": None},
}
"""What matplotlib would write of time and version, taken out so that bytes repeat."""

LONGEST_SIDE = 9.0
"""Of the picture, in inches."""


def write_plan(world: World, path: Path, *, replace: bool = False) -> None:
    """Draw a world's plan into an .svg or .png file.

    Raises UnknownPictureFormat, PictureExists unless `replace`, or PictureNotWritten.
    """
    if path.suffix not in METADATA:
        raise UnknownPictureFormat(path, METADATA)
    if path.exists() and not replace:
        raise PictureExists(path)
    import matplotlib as mpl
    from matplotlib.figure import Figure

    low, high = extent(world)
    width, height = (high - low) + 2 * LABEL_MARGIN
    scale = LONGEST_SIDE / max(width, height)
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams["svg.hashsalt"] = "omnistudy"
        figure = Figure(figsize=(max(width * scale, 5.0), height * scale + 0.8))
        axes = figure.add_axes((0.02, 0.06, 0.96, 0.86))
        draw_plan(world, axes)
        axes.set_title(world.title or world.name, fontsize=12, color="#2b2f36")
        try:
            figure.savefig(path, dpi=150, metadata=METADATA[path.suffix], facecolor="white")
        except OSError as refused:
            raise PictureNotWritten(path, refused.strerror or str(refused)) from refused

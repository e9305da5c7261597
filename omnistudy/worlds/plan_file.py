"""A plan as a picture file: same world, same bytes."""

from __future__ import annotations

from pathlib import Path

from omnistudy.pictures import picture
from omnistudy.worlds.drawing import LABEL_MARGIN, draw_plan, extent
from omnistudy.worlds.world import World

LONGEST_SIDE = 9.0
"""Of the picture, in inches."""


def write_plan(world: World, path: Path, *, replace: bool = False, grid: bool = False) -> None:
    """Draw a world's plan into an .svg or .png file.

    grid : with lines of round coordinates.

    Raises UnknownPictureFormat, PictureExists unless `replace`, or PictureNotWritten.
    """
    low, high = extent(world)
    width, height = (high - low) + 2 * LABEL_MARGIN
    scale = LONGEST_SIDE / max(width, height)
    with picture(path, replace) as figure:
        figure.set_layout_engine("none")
        figure.set_size_inches(max(width * scale, 5.0), height * scale + 0.8)
        axes = figure.add_axes((0.02, 0.06, 0.96, 0.86))
        draw_plan(world, axes, grid=grid)
        axes.set_title(world.title or world.name, fontsize=12, color="#2b2f36")

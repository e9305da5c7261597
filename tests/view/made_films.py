"""SYNTHETIC films: what a page shows when series, scene and robot are written by hand."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np

from omnistudy.plants import Plant
from omnistudy.scene import Scene
from omnistudy.view.chromium import Browser, Tab
from omnistudy.view.film import Film, Series
from omnistudy.view.page import replay_page, write_page

RECORD = "window.replay.player.reels[0].record"


def made_film(plant: Plant, scene: Scene, values: Mapping[str, Sequence[float]]) -> Film:
    """Give a film of a robot in a scene; `values` are its series, "t" among them."""
    return Film(
        study="made",
        virtual=True,
        trial=1,
        participant="P01",
        condition="A",
        masked=True,
        route="through",
        status="completed",
        end=values["t"][-1],
        duration_s=None,
        collisions=0,
        scene=scene,
        legs=(),
        links=plant.links,
        footprint=plant.footprint,
        sight=plant.sight,
        start=(0.5, 0.0, 0.0),
        series=tuple(_series(name, series) for name, series in values.items()),
        events=(),
        captions=(),
    )


def opened(chromium: Browser, film: Film, folder: Path, wish: str = "") -> Tab:
    """Show a film in a page that was opened from disk."""
    page = folder / "made.html"
    write_page(replay_page([film]), page)
    tab = chromium.tab(900, 700)
    tab.open(f"{page.as_uri()}#{wish}")
    tab.wait_for("window.replay !== undefined")
    return tab


def _series(name: str, values: Sequence[float]) -> Series:
    data = b64encode(np.asarray(values, dtype="<f4").tobytes()).decode()
    return Series(name=name, unit="1", description="made", data=data)

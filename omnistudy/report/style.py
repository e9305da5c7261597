"""How every picture looks: one colour a condition, ink and paper that follow light and dark.

Pictures are drawn with stand-in colours (STAND_INS) which the page replaces by CSS
variables, so that the same SVG is readable on a light and on a dark page. Condition colours are
those of Okabe and Ito (2008, "Color universal design"), which colour-blind readers can tell apart.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import matplotlib as mpl
from matplotlib.axes import Axes

from omnistudy.worlds import drawing as plan

INK = "#0a0b0c"
MUTED = "#5a5b5c"
LINE = "#dadbdc"
PAPER = "#fafbfc"
STAND_INS = {
    INK: "var(--ink)",
    MUTED: "var(--muted)",
    LINE: "var(--line)",
    PAPER: "var(--paper)",
    plan.INK: "var(--ink)",
    plan.WALL: "var(--wall)",
    plan.TINTS["blue"]: "var(--blue-part)",
    plan.TINTS["green"]: "var(--green-part)",
    "#ffffff": "var(--paper)",
}
"""Colour in a drawing -> CSS variable of the page; the plan's own colours too."""

WITH_COLOUR = "#0072b2"
WITHOUT_COLOUR = "#d55e00"
PUBLISHED_COLOURS = {
    "full": WITH_COLOUR,
    "none": WITHOUT_COLOUR,
    "centre_front_10": "#56b4e9",
    "centre_front_20": "#009e73",
    "centre_rear_10": "#cc79a7",
    "zero_torque": "#e69f00",
}
OTHER_COLOURS = tuple(PUBLISHED_COLOURS.values())

PUBLISHED_NAMES = {
    "full": "with feedback",
    "none": "no feedback",
    "centre_front_10": "centre 10 cm ahead",
    "centre_front_20": "centre 20 cm ahead",
    "centre_rear_10": "centre 10 cm behind",
    "zero_torque": "no torque",
}

SETTINGS = {
    "svg.fonttype": "none",
    "svg.hashsalt": "omnistudy",
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
    "text.color": INK,
    "axes.labelcolor": MUTED,
    "axes.edgecolor": LINE,
    "axes.facecolor": "none",
    "axes.linewidth": 0.8,
    "axes.titlesize": 9.5,
    "axes.titlelocation": "left",
    "axes.titlepad": 8.0,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.spines.left": False,
    "axes.axisbelow": True,
    "figure.facecolor": "none",
    "grid.color": LINE,
    "grid.linewidth": 0.7,
    "xtick.color": LINE,
    "ytick.color": LINE,
    "xtick.labelcolor": MUTED,
    "ytick.labelcolor": MUTED,
    "xtick.major.size": 0.0,
    "ytick.major.size": 0.0,
    "lines.solid_capstyle": "round",
    "legend.frameon": False,
    "path.simplify": True,
}


def colours(conditions: tuple[str, ...]) -> dict[str, str]:
    """Give each condition its colour: the published six always have the same."""
    return {
        name: PUBLISHED_COLOURS.get(name, OTHER_COLOURS[place % len(OTHER_COLOURS)])
        for place, name in enumerate(conditions)
    }


def name_of(condition: str) -> str:
    """Give a condition's name for people."""
    return PUBLISHED_NAMES.get(condition, condition.replace("_", " "))


@contextmanager
def drawing() -> Iterator[None]:
    """Draw in the house's style, whatever the reader's own matplotlib settings."""
    with mpl.rc_context():
        mpl.rcdefaults()
        mpl.rcParams.update(SETTINGS)  # type: ignore[arg-type]
        yield


def only_horizontal_lines(axes: Axes) -> None:
    """Give faint lines to read heights by, and no others."""
    axes.grid(visible=True, axis="y")
    axes.tick_params(axis="both", pad=4)

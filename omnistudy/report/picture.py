"""A drawn figure as SVG text that stands inside a page."""

from __future__ import annotations

import re
from dataclasses import dataclass
from html import escape
from io import StringIO

from matplotlib.figure import Figure

from omnistudy.report.style import INK, STAND_INS

Cell = str | int | float | None


@dataclass(frozen=True, slots=True)
class DataTable:
    """Columns (with units) and rows that a picture was drawn from."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Cell, ...], ...]


@dataclass(frozen=True, slots=True)
class Picture:
    """One figure of the page.

    key : its anchor. alt : what it shows, for who cannot see it. published : what the thesis's
    figure says, one sentence each. shown : the table under the picture; data : what its download
    holds, all rows.
    """

    key: str
    title: str
    alt: str
    caption: str
    svg: str
    published: tuple[str, ...]
    shown: DataTable
    data: DataTable


def watermark(figure: Figure, kind: str) -> None:
    """Mark a picture of simulated people as such; a picture of people stays unmarked."""
    if kind == "virtual":
        figure.text(
            0.5,
            0.5,
            "VIRTUAL",
            color=INK,
            alpha=0.055,
            fontsize=min(64.0, 9.0 * figure.get_figwidth()),
            fontweight="bold",
            ha="center",
            va="center",
            rotation=18,
            zorder=-1,
        )
        figure.text(
            0.995,
            0.995,
            "virtual participants",
            color=INK,
            alpha=0.55,
            fontsize=7.5,
            ha="right",
            va="top",
        )


def to_svg(figure: Figure, key: str, alt: str) -> str:
    """Give the figure as an `<svg>` element with its alternative text; same figure, same text.

    Every id gets the key in front, because all pictures share one page.
    """
    buffer = StringIO()
    figure.savefig(buffer, format="svg", metadata={"Date": None, "Creator": None})
    text = buffer.getvalue()
    text = text[text.index("<svg") :]
    text = re.sub(r"<metadata>.*?</metadata>", "", text, flags=re.DOTALL)
    text = re.sub(r'\bid="', f'id="{key}-', text)
    text = re.sub(r"url\(#", f"url(#{key}-", text)
    text = re.sub(r'xlink:href="#', f'href="#{key}-', text)
    text = re.sub(r' xmlns:xlink="[^"]*"| xmlns="[^"]*"| version="[^"]*"', "", text)
    text = re.sub(r' width="[\d.]+pt" height="[\d.]+pt"', "", text, count=1)
    text = re.sub(r"(\d\.\d\d)\d+", r"\1", text)  # hundredths of a point are plenty
    for stand_in, variable in STAND_INS.items():
        text = text.replace(stand_in, variable)
    label = escape(alt, quote=True)
    return text.replace("<svg", f'<svg role="img" aria-label="{label}"', 1).strip()

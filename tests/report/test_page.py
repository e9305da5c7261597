"""The page: whole, by itself, marked, and the same each time."""

from __future__ import annotations

import csv
import io
import re
import subprocess
from base64 import b64decode
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path

import matplotlib.image
import pytest
from synthetic_study import Synthetic

from omnistudy.analysis.report import analyse
from omnistudy.report.page import render
from omnistudy.report.pictures import pictures

pytestmark = pytest.mark.slow

VOID = {"meta", "br", "link", "img", "input", "hr"}


class Outline(HTMLParser):
    """Notes unclosed elements, ids, addresses and scripts."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.ids: list[str] = []
        self.addresses: list[str] = []
        self.scripts = 0

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        given = dict(attrs)
        if given.get("id"):
            self.ids.append(str(given["id"]))
        self.addresses += [str(given[key]) for key in ("href", "src") if given.get(key)]
        self.scripts += tag == "script"
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag, f"</{tag}> closes something else"


@pytest.fixture(scope="module")
def page(synthetic: Synthetic) -> str:
    published = synthetic.published()
    return render(analyse(published, synthetic.arms()), published.world)


def test_page_is_whole_and_needs_nothing_from_outside(page: str) -> None:
    outline = Outline()
    outline.feed(page)
    assert outline.open == []
    assert len(outline.ids) == len(set(outline.ids))
    assert outline.scripts == 0
    assert all(address.startswith(("#", "data:")) for address in outline.addresses)
    assert "@import" not in page
    assert "url(http" not in page
    assert 'font-family: "DejaVu Sans"' in page, "style sheets know no escaped quotes"


def test_every_picture_says_what_it_shows_and_is_marked_virtual(page: str) -> None:
    drawn = re.findall(r"<svg.*?</svg>", page, re.S)
    assert len(drawn) == 7
    for svg in drawn:
        assert re.search(r'role="img" aria-label="[^"]{40,}"', svg)
        assert "VIRTUAL" in svg
        assert "virtual participants" in svg
    assert "simulated, no human data" in page


def test_downloads_hold_the_numbers_behind_each_picture(page: str, synthetic: Synthetic) -> None:
    report = analyse(synthetic.published(), synthetic.arms())
    links = re.findall(r'download="([^"]*)\.csv" href="data:text/csv[^,]*;base64,([^"]*)"', page)
    assert len(links) == 7
    files = dict(links)
    for picture in pictures(report, synthetic.world()):
        data = b64decode(files[f"synthetic_utah2017-{picture.key}"]).decode("utf-8-sig")
        header, *rows = csv.reader(io.StringIO(data))
        assert tuple(header) == picture.data.columns
        assert len(rows) == len(picture.data.rows)


def test_thesis_table_tells_hits_and_misses_alike(page: str) -> None:
    for claim in ("Mean collisions without feedback", "Mean collisions with feedback"):
        assert claim in page
    verdicts = re.findall(r'<td class="verdict (\w+)">', page)
    assert set(verdicts) >= {"calibrated", "hit", "miss"}


def test_trials_out_of_time_are_told(page: str) -> None:
    assert "1 of 8 trials “centre 10 cm behind”. Such a trial counts" in page
    assert "All reached the finish." in page, "those of the arm-stiffness study"


def test_same_study_gives_the_same_bytes(page: str, synthetic: Synthetic) -> None:
    published = synthetic.published()
    assert render(analyse(published, synthetic.arms()), published.world) == page


def test_a_study_of_another_design_has_no_thesis_in_it(synthetic: Synthetic) -> None:
    rows = [
        (n, f"P{n:02d}", 1, 1, 1, "wide & <odd>", 1, "there", "completed", 60.0, 0, 0)
        for n in (1, 2)
    ]
    other = synthetic.tables("other", rows, ("wide & <odd>",))
    text = render(analyse(other), other.world)
    assert "Beside the thesis" not in text
    assert "<odd>" not in text
    Outline().feed(text)


def test_a_study_of_people_is_not_marked_virtual(synthetic: Synthetic) -> None:
    rows = [(1, "P01", 1, 1, 1, "full", 1, "there", "completed", 60.0, 3, 3)]
    people = synthetic.tables("people", rows, ("full",), kind="human")
    assert "VIRTUAL" not in render(analyse(people), people.world)


def test_page_in_a_browser_is_not_blank(
    page: str, tmp_path: Path, requires_program: Callable[[str, str], str]
) -> None:
    chromium = requires_program("chromium", "chromium")
    file, shot = tmp_path / "report.html", tmp_path / "report.png"
    file.write_text(page, encoding="utf-8")
    subprocess.run(
        [
            chromium,
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--disable-background-networking",
            f"--user-data-dir={tmp_path / 'profile'}",
            f"--screenshot={shot}",
            "--window-size=1100,2400",
            file.as_uri(),
        ],
        check=True,
        capture_output=True,
        timeout=120,
    )
    pixels = matplotlib.image.imread(shot)
    assert pixels.shape[:2] == (2400, 1100)
    ink = (pixels[..., :3].mean(axis=2) < 0.5).mean(axis=1)
    assert (ink > 0.0).mean() > 0.3, "text and figures reach over the page"

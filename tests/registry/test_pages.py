from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.worlds import BrokenWorld
from omnistudy.registry.pages import page_content


def test_a_page_that_is_no_yaml_is_told_with_the_line_a_person_counts(tmp_path: Path) -> None:
    page = tmp_path / "maze.yaml"
    page.write_text("kind: plan\nname: [maze\ntitle: Maze\n")
    with pytest.raises(BrokenWorld, match=r"maze\.yaml, line 3: not readable as YAML"):
        page_content(page, BrokenWorld)

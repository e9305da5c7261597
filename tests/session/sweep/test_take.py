from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from small_sweep import ARMS, GAINS, PROTOCOL, SHORT, question, small_plan

from omnistudy.errors.sweep import ForeignFolder, PageExists, PageNotWritten, ProtocolMoved
from omnistudy.protocol.compose import compose_protocol, find_protocol
from omnistudy.session.sweep.planning import Question, Thinning, plan_sweep
from omnistudy.session.sweep.question import Sweep
from omnistudy.session.sweep.take import take


@pytest.fixture
def sweep() -> Sweep:
    return small_plan().sweep


def test_a_taken_page_is_a_protocol_that_says_what_was_chosen(tmp_path: Path, sweep: Sweep) -> None:
    page = tmp_path / "chosen.yaml"
    take(sweep, {"law.stiffness.x": 400}, ["Row 2 of a sweep", "", "mean 3"], page)
    assert page.read_text().startswith("# Row 2 of a sweep\n#\n# mean 3\n\ndefaults:\n")
    taken = compose_protocol(page)
    wanted = compose_protocol(PROTOCOL, (*SHORT, "law.stiffness.x=400"))
    assert taken == wanted.model_copy(update={"name": "chosen"})


def test_a_chosen_page_and_a_chosen_word_are_written_where_they_belong(tmp_path: Path) -> None:
    sweep = plan_sweep(question("device=simulated_stick,direct", GAINS)).sweep
    page = tmp_path / "2-direct.yaml"
    take(sweep, {"device": "direct", "law.stiffness.x": 100}, (), page)
    taken = compose_protocol(page)
    assert taken.device.kind == "direct"
    assert taken.name == "utah2017_component_taken"


def test_a_page_is_not_overwritten_unasked(tmp_path: Path, sweep: Sweep) -> None:
    page = tmp_path / "chosen.yaml"
    page.write_text("mine")
    with pytest.raises(PageExists, match="--force"):
        take(sweep, {"law.stiffness.x": 400}, (), page)
    assert page.read_text() == "mine"
    take(sweep, {"law.stiffness.x": 400}, (), page, replace=True)
    assert "defaults:" in page.read_text()


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("chosen.txt", "a protocol's page is called NAME.yaml"),
        ("utah2017_component.yaml", "it would rest on itself"),
        ("nowhere/chosen.yaml", "No such file or directory"),
    ],
)
def test_a_page_that_cannot_be_is_refused(
    tmp_path: Path, sweep: Sweep, name: str, said: str
) -> None:
    with pytest.raises(PageNotWritten, match=said):
        take(sweep, {"law.stiffness.x": 400}, (), tmp_path / name)


def own_protocol(folder: Path) -> tuple[Path, Sweep]:
    """Sweep a copy of the published protocol that is given as a file."""
    file = folder / "mine.yaml"
    file.write_text(find_protocol(PROTOCOL).read_text(encoding="utf-8"), encoding="utf-8")
    words: tuple[Any, ...] = (GAINS, ARMS, *SHORT)
    asked = Question(str(file), words, thinning=Thinning(trials=1))
    return file, plan_sweep(asked).sweep


def test_a_page_on_a_file_lies_beside_it(tmp_path: Path) -> None:
    file, sweep = own_protocol(tmp_path)
    (tmp_path / "elsewhere").mkdir()
    with pytest.raises(ForeignFolder, match="would not find the protocol it rests on"):
        take(sweep, {"law.stiffness.x": 400}, (), tmp_path / "elsewhere" / "chosen.yaml")
    take(sweep, {"law.stiffness.x": 400}, (), file.with_name("chosen.yaml"))
    assert compose_protocol(tmp_path / "chosen.yaml").law.model_dump()["stiffness"]["x"] == 400


def test_nothing_is_taken_from_a_protocol_that_was_changed(tmp_path: Path) -> None:
    file, sweep = own_protocol(tmp_path)
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("pause: 60", "pause: 90"), encoding="utf-8")
    with pytest.raises(ProtocolMoved, match=r"changed: session\.pause"):
        take(sweep, {"law.stiffness.x": 400}, (), tmp_path / "chosen.yaml")
    assert not (tmp_path / "chosen.yaml").exists()

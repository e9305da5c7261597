"""What may be chosen: kinds, and the pages of the lab and ours."""

from __future__ import annotations

from pathlib import Path

import pytest

from omnistudy.errors.registry import PageOfUnknownKind, UnknownKindOrPage
from omnistudy.registry import kinds
from omnistudy.registry.catalogue import NOT_READABLE, entries, find, names, pages

GROUPS = ("laws", "controllers", "plants", "devices", "operators", "tasks", "orders", "worlds")


@pytest.fixture
def lab(tmp_path: Path) -> Path:
    """A lab that has a stiffer component law under two names, and a page of its own making."""
    folder = tmp_path / "lab"
    (folder / "law").mkdir(parents=True)
    stiff = "# Twice as stiff:\n# a second line\nkind: component\nstiffness: {x: 400, y: 250}\n"
    (folder / "law" / "stiff.yaml").write_text(stiff)
    (folder / "law" / "component.yaml").write_text("kind: component  # ours, but softer\n")
    (folder / "law" / "grip.yaml").write_text("kind: grip\n")
    (folder / "law" / "torn.yaml").write_text("kind: [")
    return folder


@pytest.mark.parametrize("group", GROUPS)
def test_every_kind_says_what_it_is_in_a_sentence(group: str) -> None:
    found = entries(group)
    assert [entry.kind for entry in found] == list(kinds(group))
    for entry in found:
        assert entry.summary.endswith(".")
        assert "\n" not in entry.summary
        assert entry.package == "omnistudy"


@pytest.mark.parametrize("group", [group for group in GROUPS if group != "worlds"])
def test_every_page_of_ours_is_of_a_kind_that_there_is_and_says_what_it_is(group: str) -> None:
    for page in pages(group):
        assert page.kind in kinds(group)
        assert page.summary, f"{page.file} begins without a comment"


def test_the_labs_page_hides_ours_of_the_same_name(lab: Path) -> None:
    found = {page.name: page for page in pages("laws", lab)}
    assert found["component"].file == lab / "law" / "component.yaml"
    assert found["component"].summary == "ours, but softer"
    assert found["none"].file.parent != lab / "law"


def test_a_page_says_its_first_comment_and_what_it_sets(lab: Path) -> None:
    stiff = find("laws", "stiff", lab)
    assert stiff.entry.kind == "component"
    assert stiff.page is not None
    assert stiff.page.summary == "Twice as stiff"
    assert stiff.page.sets == (("stiffness.x", 400), ("stiffness.y", 250))


def test_a_kind_without_a_page_is_found_too() -> None:
    found = find("orders", "latin")
    assert (found.entry.kind, found.page) == ("latin", None)


def test_a_page_that_is_no_yaml_is_listed_as_such(lab: Path) -> None:
    torn = next(page for page in pages("laws", lab) if page.name == "torn")
    assert (torn.kind, torn.summary) == (None, NOT_READABLE)


def test_names_are_kinds_and_pages(lab: Path) -> None:
    assert {"none", "component", "stiff", "grip"} <= set(names("laws", lab))


def test_an_unknown_name_gets_the_nearest_page_or_kind(lab: Path) -> None:
    with pytest.raises(UnknownKindOrPage, match="did you mean 'stiff'"):
        find("laws", "stif", lab)


def test_a_page_whose_package_is_not_installed_says_so(lab: Path) -> None:
    with pytest.raises(PageOfUnknownKind, match=r"grip\.yaml is of the kind 'grip'.*install"):
        find("laws", "grip", lab)

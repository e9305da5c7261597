from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from omnistudy.protocol.completion import completed, laid_over

trees = st.recursive(
    st.integers() | st.text(max_size=3),
    lambda inner: st.dictionaries(st.sampled_from(["kind", "a", "b", "c"]), inner, max_size=4),
    max_leaves=8,
)


def test_a_change_is_laid_over_at_every_depth() -> None:
    base = {"kind": "k", "gain": 1, "axis": {"x": 1, "y": 2}, "list": [1, 2]}
    change = {"axis": {"y": 3}, "list": [9], "more": True}
    assert laid_over(base, change) == {
        "kind": "k",
        "gain": 1,
        "axis": {"x": 1, "y": 3},
        "list": [9],
        "more": True,
    }
    assert base["axis"] == {"x": 1, "y": 2}


def test_another_kind_replaces_at_any_depth() -> None:
    base = {"kind": "k", "edge": {"kind": "round", "radius": 1}}
    assert laid_over(base, {"kind": "other", "n": 1}) == {"kind": "other", "n": 1}
    assert laid_over(base, {"edge": {"kind": "square", "side": 2}}) == {
        "kind": "k",
        "edge": {"kind": "square", "side": 2},
    }


def test_the_same_kind_written_again_changes_nothing_else() -> None:
    assert laid_over({"kind": "k", "a": 1, "b": 2}, {"kind": "k", "a": 3}) == {
        "kind": "k",
        "a": 3,
        "b": 2,
    }


@given(trees)
def test_a_tree_laid_over_itself_is_itself(tree: object) -> None:
    assert laid_over(tree, tree) == tree


@given(trees, trees)
def test_laying_twice_is_laying_once(base: object, change: object) -> None:
    once = laid_over(base, change)
    assert laid_over(once, change) == once


def page(group: str, name: str) -> dict[str, object]:
    """Stands for the pages of conf: their content tells which one it is."""
    return {"kind": name, "from": f"conf/{group}/{name}.yaml"}


def test_mappings_become_lists_and_levels_follow_the_factors() -> None:
    full = completed(
        {
            "factors": {"force": ["no", "yes"], "centre": [0]},
            "law": {"kind": "k", "a": 1, "b": 2},
            "conditions": {"one": {"levels": {"centre": 0, "force": "no"}, "law": {"b": 3}}},
        },
        page,
    )
    assert full["factors"][0] == {"name": "force", "levels": ["no", "yes"]}
    assert full["conditions"] == [
        {
            "name": "one",
            "levels": [{"factor": "force", "level": "no"}, {"factor": "centre", "level": 0}],
            "law": {"kind": "k", "a": 1, "b": 3},
        }
    ]


def test_without_conditions_every_cell_of_the_factors_is_one() -> None:
    full = completed(
        {
            "law": {"kind": "k", "a": 1},
            "factors": {
                "force": {"vary": "between", "levels": {"no": {"law": "none"}, "yes": {}}},
                "centre": {"levels": {0: {}, -0.1: {"law": {"a": 2}}}},
            },
        },
        page,
    )
    none = {"kind": "none", "from": "conf/law/none.yaml"}
    assert full["factors"][0] == {"name": "force", "vary": "between", "levels": ["no", "yes"]}
    assert [(one["name"], one["masked_label"], one.get("law")) for one in full["conditions"]] == [
        ("no_centre_0", "A", none),
        ("no_centre_minus_0_1", "B", none | {"a": 2}),
        ("yes_centre_0", "C", None),
        ("yes_centre_minus_0_1", "D", {"kind": "k", "a": 2}),
    ]


def test_a_condition_is_laid_over_its_levels() -> None:
    full = completed(
        {
            "law": {"kind": "k", "a": 1, "b": 1, "c": 1},
            "factors": {"force": {"levels": {"yes": {"law": {"a": 2, "b": 2}}}}},
            "conditions": {"one": {"levels": {"force": "yes"}, "law": {"b": 3}}},
        },
        page,
    )
    assert full["conditions"][0]["law"] == {"kind": "k", "a": 2, "b": 3, "c": 1}


def test_after_z_comes_aa() -> None:
    levels = {f"l{index}": {} for index in range(28)}
    full = completed({"factors": {"force": {"levels": levels}}}, page)
    assert [one["masked_label"] for one in full["conditions"]][24:] == ["Y", "Z", "AA", "AB"]


def test_visits_and_strata_may_be_mappings() -> None:
    full = completed(
        {
            "visits": {"first": {"blocks": [{"only": {"force": "no"}}]}},
            "participants": {"strata": {"young": 3, "old": {"count": 4}}},
        },
        page,
    )
    only = [{"factor": "force", "level": "no"}]
    assert full["visits"] == [{"name": "first", "blocks": [{"only": only}]}]
    assert full["participants"]["strata"] == [
        {"name": "young", "count": 3},
        {"name": "old", "count": 4},
    ]


def test_what_is_no_mapping_is_left_for_the_models() -> None:
    tree = {"factors": 3, "conditions": {"one": "two"}}
    assert completed(tree, page) == {"factors": 3, "conditions": ["two"]}

"""Parameters of a kind: their list, and settings typed by a person."""

from __future__ import annotations

import pytest

from omnistudy.errors import UnknownKind
from omnistudy.errors.parameters import BadParameter, NotASetting, UnknownParameter
from omnistudy.laws.boundary import RectangularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.registry.parameters import make_kind, parameters


def test_nested_parameters_are_listed_with_unit_and_meaning() -> None:
    listed = {parameter.name: parameter for parameter in parameters(ComponentLaw)}
    assert "kind" not in listed
    assert "boundary.kind" not in listed
    layer = listed["boundary.layer_x"]
    assert (layer.default, layer.unit) == (0.15, "m")
    assert layer.meaning == "Thickness of the layer ahead and behind (appendix B)."
    assert listed["stiffness.theta"].unit == "N·m/m²"
    assert (listed["as_published"].default, listed["as_published"].unit) == (False, "")
    assert all(parameter.meaning for parameter in listed.values())
    assert parameters(NoLaw) == ()


def test_settings_change_what_they_name_and_nothing_else() -> None:
    law = make_kind(
        "laws",
        "component",
        ["boundary.layer_x=0.2", "stiffness.x=1e2", "as_published=true", "compliance_centre=-0.1"],
    )
    plain = ComponentLaw()
    assert (law.boundary.layer_x, law.stiffness.x) == (0.2, 100.0)
    assert (law.as_published, law.compliance_centre) == (True, -0.1)
    assert (law.boundary.layer_y, law.stiffness.y) == (plain.boundary.layer_y, plain.stiffness.y)
    assert law.damping == plain.damping


def test_without_settings_it_is_the_default() -> None:
    assert make_kind("laws", "component") == ComponentLaw()


@pytest.mark.parametrize("setting", ["boundary.layer_x", "=1", ""])
def test_a_setting_is_a_name_and_a_value(setting: str) -> None:
    with pytest.raises(NotASetting, match="write name=value"):
        make_kind("laws", "component", [setting])


@pytest.mark.parametrize(
    ("name", "nearest"),
    [
        ("boundary.layr_x", "boundary.layer_x"),
        ("complience_centre", "compliance_centre"),
        ("stifness.theta", "stiffness.theta"),
    ],
)
def test_a_wrong_name_is_told_the_nearest(name: str, nearest: str) -> None:
    with pytest.raises(UnknownParameter, match=f"did you mean '{nearest}'"):
        make_kind("laws", "component", [f"{name}=1"])


@pytest.mark.parametrize("name", ["kind", "boundary", "boundary.kind", "boundary.layer_x.y", "."])
def test_only_parameters_can_be_set(name: str) -> None:
    with pytest.raises(UnknownParameter):
        make_kind("laws", "component", [f"{name}=1"])


def test_a_kind_without_parameters_says_so() -> None:
    with pytest.raises(UnknownParameter, match="it has none"):
        make_kind("laws", "none", ["gain=1"])


@pytest.mark.parametrize(
    ("setting", "said"),
    [
        ("boundary.layer_x=-0.1", "boundary.layer_x = -0.1: Input should be greater"),
        ("boundary.half_width=0", "boundary.half_width = 0: Input should be greater than 0"),
        ("boundary.layer_x=nan", "finite"),
        ("boundary.layer_x=10 cm", "a plain number in m is needed"),
        ("stiffness.x=true", "a plain number in N/m is needed"),
        ("as_published=perhaps", "as_published = 'perhaps'"),
    ],
)
def test_a_wrong_value_is_told_with_its_name(setting: str, said: str) -> None:
    with pytest.raises(BadParameter) as caught:
        make_kind("laws", "component", [setting])
    assert said in str(caught.value)


def test_a_wrong_kind_is_told_the_nearest() -> None:
    with pytest.raises(UnknownKind, match="did you mean 'component'"):
        make_kind("laws", "compnent")


class Thick(ComponentLaw):
    """A law whose own default differs from that of what it holds."""

    boundary: RectangularBoundary = RectangularBoundary(layer_x=0.3)


def test_what_is_not_named_keeps_the_default_of_the_kind(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("omnistudy.registry.parameters.load_kind", lambda group, kind: Thick)
    law = make_kind("laws", "component", ["boundary.layer_y=0.2"])
    assert (law.boundary.layer_x, law.boundary.layer_y) == (0.3, 0.2)

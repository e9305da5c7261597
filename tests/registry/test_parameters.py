"""Parameters of a kind: their list, and settings typed by a person."""

from __future__ import annotations

import pytest

from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.errors import UnknownKind
from omnistudy.errors.parameters import BadParameter, NotASetting, UnknownParameter
from omnistudy.laws.boundary import CircularBoundary, RectangularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.registry.parameters import make_kind, parameters


def test_nested_parameters_are_listed_with_unit_and_meaning() -> None:
    listed = {parameter.name: parameter for parameter in parameters(ComponentLaw)}
    assert "kind" not in listed
    assert "stiffness.kind" not in listed
    layer = listed["boundary.layer_x"]
    assert (layer.default, layer.unit) == (0.15, "m")
    assert layer.meaning == "Thickness of the layer ahead and behind (appendix B)."
    assert listed["stiffness.theta"].unit == "N·m/m²"
    assert (listed["as_published"].default, listed["as_published"].unit) == (False, "")
    assert all(parameter.meaning for parameter in listed.values())
    assert parameters(NoLaw) == ()


def test_a_part_is_listed_with_the_numbers_that_its_owner_gives_it() -> None:
    """The stick's axes differ from an axis's own defaults: gravity 100 in x, 70 in y."""
    listed = {parameter.name: parameter.default for parameter in parameters(SimulatedStick)}
    assert (listed["x.gravity"], listed["y.gravity"], listed["theta.gravity"]) == (100, 70, 0)
    assert listed["theta.proportional"] == pytest.approx(1.9 * 0.7)


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


@pytest.mark.parametrize("name", ["kind", "boundary", "stiffness.kind", "boundary.layer_x.y", "."])
def test_only_parameters_can_be_set(name: str) -> None:
    with pytest.raises(UnknownParameter):
        make_kind("laws", "component", [f"{name}=1"])


def test_which_kind_a_part_is_of_is_a_parameter_where_there_is_a_choice() -> None:
    listed = {parameter.name: parameter for parameter in parameters(ComponentLaw)}
    assert listed["boundary.kind"].default == "rectangular"
    assert listed["boundary.kind"].meaning == "One of rectangular, circular."
    assert listed["boundary.radius"].meaning.startswith("Of kind circular. ")


@pytest.mark.parametrize("backwards", [False, True])
def test_a_part_of_another_kind_keeps_nothing_of_the_first(backwards: bool) -> None:
    settings = ["boundary.kind=circular", "boundary.radius=0.4"]
    law = make_kind("laws", "component", settings[::-1] if backwards else settings)
    assert law.boundary == CircularBoundary(radius=0.4)
    same = make_kind("laws", "component", ["boundary.kind=rectangular", "boundary.layer_x=0.2"])
    assert same.boundary == RectangularBoundary(layer_x=0.2)


@pytest.mark.parametrize(
    ("settings", "said"),
    [
        (["boundary.radius=0.4"], "boundary.radius: unknown key; the keys here are kind, half_le"),
        (["boundary.kind=circular", "boundary.layer_x=0.2"], "boundary.layer_x: unknown key; the"),
        (
            ["boundary.kind=circula"],
            "boundary: unknown kind 'circula': it is one of rectangular, c",
        ),
    ],
)
def test_what_belongs_to_another_kind_of_part_is_refused(settings: list[str], said: str) -> None:
    with pytest.raises(BadParameter) as caught:
        make_kind("laws", "component", settings)
    assert said in str(caught.value)


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

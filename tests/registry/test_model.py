"""Frozen models from a page: what they refuse, and that a changed copy is as sound as a new one."""

from __future__ import annotations

from functools import cached_property
from math import inf, nan
from typing import Annotated, Any, Literal

import pytest
from core_world import straight_world, wall_ahead
from pydantic import ValidationError

from omnistudy.errors import UnknownKind
from omnistudy.laws import Law
from omnistudy.registry import KindModel, Model, kind_validator, kinds, load_kind
from omnistudy.units import Metres, Positive


class Table(Model):
    """A thing with a size."""

    length: Annotated[Metres, Positive] = 2.0
    """Along the wall."""
    width: Metres = 1.0

    @cached_property
    def area(self) -> float:
        return self.length * self.width


class Holder(Model):
    """Something that holds a law."""

    law: Annotated[Law, kind_validator("laws")]


@pytest.mark.parametrize("given", ["1 m", "1.0", True, nan, inf, None])
def test_a_quantity_is_a_plain_finite_number(given: Any) -> None:
    with pytest.raises(ValidationError):
        Table(width=given)


def test_a_text_with_a_unit_is_answered_with_the_unit() -> None:
    with pytest.raises(ValidationError, match="a plain number in m is needed, without a unit"):
        Table.model_validate({"width": "10 cm"})


@pytest.mark.parametrize("given", [{"lenght": 1.0}, {"length": 0.0}, {"length": -1.0}])
def test_unknown_keys_and_bounds_are_refused(given: dict[str, float]) -> None:
    with pytest.raises(ValidationError):
        Table.model_validate(given)


def test_a_model_is_frozen() -> None:
    with pytest.raises(ValidationError):
        Table().width = 3.0  # type: ignore[misc]


def test_units_are_in_the_schema_and_meanings_are_docstrings() -> None:
    length = Table.model_json_schema()["properties"]["length"]
    assert (length["unit"], length["description"]) == ("m", "Along the wall.")


def test_a_copy_forgets_what_was_remembered() -> None:
    table = Table(width=3.0)
    assert table.area == 6.0
    longer = table.model_copy(update={"length": 4.0})
    assert (longer.area, longer.width) == (12.0, 3.0)
    assert table.area == 6.0


def test_a_copy_is_checked_like_a_new_one() -> None:
    for update in ({"length": -1.0}, {"lenght": 1.0}):
        with pytest.raises(ValidationError):
            Table().model_copy(update=update)


def test_a_wall_added_to_a_used_world_stands_in_its_scene() -> None:
    world = straight_world()
    before = len(world.scene.bodies)
    fuller = world.model_copy(update={"bodies": (*world.bodies, wall_ahead(1.0))})
    assert len(fuller.scene.bodies) == before + 1


def test_kind_picks_the_class() -> None:
    held = Holder.model_validate({"law": {"kind": "component", "compliance_centre": 0.1}})
    assert type(held.law) is load_kind("laws", "component")
    assert Holder(law=held.law).law is held.law


@pytest.mark.parametrize(
    ("law", "answer"),
    [
        ({"kind": "componet"}, "did you mean 'component'"),
        ({"compliance_centre": 0.1}, "a mapping with 'kind' is needed"),
        ("component", "a mapping with 'kind' is needed"),
        ({"kind": "component", "complaince_centre": 0.1}, "complaince_centre"),
    ],
)
def test_a_wrong_kind_is_answered_with_what_is_allowed(law: Any, answer: str) -> None:
    with pytest.raises(ValidationError, match=answer):
        Holder.model_validate({"law": law})


GROUPS = ["laws", "controllers", "plants", "devices", "operators", "tasks", "worlds", "orders"]


@pytest.mark.parametrize("group", GROUPS)
def test_every_built_in_kind_loads_and_answers_to_its_name(group: str) -> None:
    assert kinds(group)
    for kind in kinds(group):
        chosen = load_kind(group, kind)
        assert issubclass(chosen, KindModel)
        annotation = chosen.model_fields["kind"].annotation
        assert annotation == Literal[kind]


def test_an_unknown_kind_names_the_nearest() -> None:
    with pytest.raises(UnknownKind, match="did you mean 'youbot'") as caught:
        load_kind("plants", "yubot")
    assert (caught.value.group, caught.value.given) == ("plants", "yubot")


def test_what_a_mapping_leaves_out_stays_as_its_owner_has_it() -> None:
    from omnistudy.devices.simulated_stick import SimulatedStick
    from omnistudy.laws.infrared import InfraredLaw
    from omnistudy.laws.sector_sum import SectorSumLaw

    law = InfraredLaw.model_validate({"boundary": {"layer_x": 0.3}})
    own = InfraredLaw().boundary
    assert law.boundary == own.model_copy(update={"layer_x": 0.3})
    stick = SimulatedStick.model_validate({"theta": {"travel": 100}})
    assert stick.theta.proportional == SimulatedStick().theta.proportional
    assert SectorSumLaw.model_validate({"boundary": {"radius": 0.4}}).boundary.kind == "circular"


def test_another_kind_replaces_a_part_whole() -> None:
    from omnistudy.laws.infrared import InfraredLaw

    law = InfraredLaw.model_validate({"boundary": {"kind": "circular"}})
    assert law.boundary.kind == "circular"

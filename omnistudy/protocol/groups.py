"""Groups: what a participant meets is decided by the levels of the factors between participants."""

from __future__ import annotations

from typing import NamedTuple

from omnistudy.protocol.condition import Condition
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.visit import Block


class Group(NamedTuple):
    """Participants who meet the same conditions; `name` is "" when all do."""

    name: str
    conditions: tuple[str, ...]


def groups(protocol: Protocol) -> tuple[Group, ...]:
    """Give the groups in the order in which the protocol's conditions show them."""
    between = [factor.name for factor in protocol.factors if factor.vary == "between"]
    members: dict[str, list[str]] = {}
    for condition in protocol.conditions:
        members.setdefault(_group_of(condition, between), []).append(condition.name)
    return tuple(Group(name, tuple(conditions)) for name, conditions in members.items())


def met_in(protocol: Protocol, block: Block, group: Group) -> tuple[str, ...]:
    """Name the conditions that a group meets in a block."""
    wanted = set(block.only)
    return tuple(
        name for name in group.conditions if wanted <= set(protocol.condition(name).levels)
    )


def _group_of(condition: Condition, between: list[str]) -> str:
    levels = {level.factor: level.level for level in condition.levels}
    return " ".join(levels[factor] for factor in between if factor in levels)

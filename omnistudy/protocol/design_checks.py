"""Faults of a design: factors, blocks and their orders, visits, groups that stay empty."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from itertools import combinations

from omnistudy.errors import nearest
from omnistudy.protocol.completion import PARTS
from omnistudy.protocol.condition import Level
from omnistudy.protocol.groups import Group, groups, met_in
from omnistudy.protocol.ordering.order import PlannedOrder, Seat
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.visit import Block


def factor_faults(protocol: Protocol) -> Iterator[str]:
    """Find levels that change nothing: conditions that differ in one factor have one set-up."""
    same: dict[tuple[Level, Level], bool] = {}
    for one, other in combinations(protocol.conditions, 2):
        differ = [
            pair for pair in zip(one.levels, other.levels, strict=False) if len(set(pair)) > 1
        ]
        if len(differ) == 1:
            alike = protocol.setup_for(one.name) == protocol.setup_for(other.name)
            same[differ[0]] = same.get(differ[0], True) and alike
    for (first, second), alike in same.items():
        if alike:
            yield (
                f"factors.{first.factor}: levels '{first.level}' and '{second.level}' have the "
                f"same set-up: let one of them override one of {', '.join(PARTS)}, or take the "
                "factor out"
            )


def course_faults(protocol: Protocol) -> Iterator[str]:
    """Find orders that cannot order what they are given, and conditions that nobody meets."""
    if (protocol.order is None) == (not protocol.visits):
        given = "neither is given" if protocol.order is None else "both are given"
        yield f"order: {given}: give an order, or visits whose blocks have orders of their own"
        return
    met: set[str] = set()
    for where, block in _blocks(protocol):
        yield from _only(protocol, where, block)
        for group in groups(protocol):
            names = met_in(protocol, block, group)
            yield from (f"{where}order: {fault}" for fault in _unordered(block, names, group))
            met.update(_named(block, names))
        yield from _catch(protocol, where, block)
        met.update({block.catch.condition} if block.catch else ())
    for condition in protocol.conditions:
        if condition.name not in met:
            yield (
                f"order: condition '{condition.name}' is never met: put it into an order or take "
                "it out"
            )


def _unordered(block: Block, names: tuple[str, ...], group: Group) -> Iterator[str]:
    of_group = f" of group '{group.name}'" if group.name else ""
    if not names:
        only = ", ".join(f"{level.factor} {level.level}" for level in block.only)
        yield f"no condition{of_group} is left by only {only}"
    elif faults := tuple(block.order.faults(names)):
        yield from (f"{fault}{f' ({of_group.strip()})' if of_group else ''}" for fault in faults)
    elif block.order.trials(names) < 1:
        yield "it gives no trial"


def _only(protocol: Protocol, where: str, block: Block) -> Iterator[str]:
    levels = {factor.name: factor.levels for factor in protocol.factors}
    for given in block.only:
        allowed = levels.get(given.factor, ())
        if given.factor not in levels:
            yield (
                f"{where}only.{given.factor}: unknown factor: the factors are "
                f"{', '.join(levels) or 'none'}{nearest(given.factor, levels)}"
            )
        elif given.level not in allowed:
            yield (
                f"{where}only.{given.factor}: unknown level '{given.level}': the levels are "
                f"{', '.join(allowed)}{nearest(given.level, allowed)}"
            )


def _named(block: Block, names: tuple[str, ...]) -> tuple[str, ...]:
    """Name what a block can meet; an order that adapts may meet all."""
    if not isinstance(block.order, PlannedOrder) or not names or any(block.order.faults(names)):
        return names
    return block.order.sequence(names, Seat(0, ""))


def _catch(protocol: Protocol, where: str, block: Block) -> Iterator[str]:
    if block.catch is None:
        return
    names = [condition.name for condition in protocol.conditions]
    if block.catch.condition not in names:
        yield (
            f"{where}catch.condition: unknown condition '{block.catch.condition}': the conditions "
            f"are {', '.join(names)}{nearest(block.catch.condition, names)}"
        )
    for group in groups(protocol):
        met = met_in(protocol, block, group)
        if met and not any(block.order.faults(met)):
            trials = block.order.trials(met)
            if block.catch.trials >= trials:
                yield (
                    f"{where}catch.trials: {block.catch.trials} catch trials do not fit between "
                    f"{trials} trials: at most {trials - 1}"
                )


def visit_faults(protocol: Protocol) -> Iterator[str]:
    """Find visits with one name and windows that cannot follow each other."""
    names = Counter(visit.name for visit in protocol.visits)
    yield from (f"visits: {n} visits are called '{name}'" for name, n in names.items() if n > 1)
    before = 0
    for place, visit in enumerate(protocol.visits):
        if place == 0 and visit.days is not None:
            yield f"visits.{visit.name}.days: days count from the first visit, which has none"
        elif visit.days is not None and visit.days.latest < before:
            yield (
                f"visits.{visit.name}.days: latest day {visit.days.latest} is before day {before}, "
                "the earliest of the visit before it"
            )
        before = visit.days.earliest if visit.days and place else before


def place_faults(protocol: Protocol) -> Iterator[str]:
    """Find strata that do not add up, and groups that nobody would be in."""
    people, names = protocol.participants, [group.name for group in groups(protocol)]
    total = sum(stratum.count for stratum in people.strata)
    if people.strata and total != people.count:
        yield (
            f"participants.strata: their counts make {total}, but participants.count is "
            f"{people.count}: make them agree"
        )
    for name, count in [(one.name, one.count) for one in people.strata] or [("", people.count)]:
        if count < len(names):
            where = f"strata.{name}.count" if name else "count"
            yield (
                f"participants.{where}: {count} cannot fill {len(names)} groups "
                f"({', '.join(names)}): the design cannot balance; give at least {len(names)}"
            )


def _blocks(protocol: Protocol) -> Iterator[tuple[str, Block]]:
    """Give every block with its path on the page; a bare order has none."""
    for visit in protocol.course:
        for place, block in enumerate(visit.blocks, start=1):
            yield f"visits.{visit.name}.blocks.{place}." if protocol.visits else "", block

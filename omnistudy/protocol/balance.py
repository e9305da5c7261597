"""At which sample sizes a design balances, and what is lost at its own."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from math import lcm
from typing import NamedTuple

from omnistudy.protocol.groups import Group, groups, met_in
from omnistudy.protocol.ordering.counts import spread
from omnistudy.protocol.ordering.order import PlannedOrder, Seat
from omnistudy.protocol.plan import PlannedTrial, StudyPlan
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.visit import Block


class Balance(NamedTuple):
    """How even a design is.

    multiple : it balances at every multiple of so many participants (of a stratum, if there are
        strata).
    participants : how many there are to be, of each stratum.
    losses : what is uneven at that number, one sentence each.
    """

    multiple: int
    participants: tuple[int, ...]
    losses: tuple[str, ...]


def balance(protocol: Protocol) -> Balance:
    """Find the sizes at which places, neighbours, routes and groups are even, and the losses.

    Orders that adapt promise nothing and are left out.
    """
    people = protocol.participants
    counts = tuple(stratum.count for stratum in people.strata) or (people.count,)
    found = groups(protocol)
    rows = lcm(*(_period(protocol, block, group) for block in _blocks(protocol) for group in found))
    return Balance(len(found) * rows, counts, tuple(_losses(protocol, StudyPlan(protocol))))


def _blocks(protocol: Protocol) -> list[Block]:
    return [block for visit in protocol.course for block in visit.blocks]


def _period(protocol: Protocol, block: Block, group: Group) -> int:
    """Give the number of rows after which a group is even in a block."""
    conditions = met_in(protocol, block, group)
    if not isinstance(block.order, PlannedOrder) or not conditions:
        return 1
    routes = len(block.routes or protocol.routes)
    met = list(Counter(block.order.sequence(conditions, Seat(0, ""))).values())
    if block.catch is not None:
        met.append(block.catch.trials)
    uneven = any(count % routes for count in met)
    return lcm(block.order.period(conditions), routes if uneven else 1)


def _losses(protocol: Protocol, plan: StudyPlan) -> Iterator[str]:
    members: dict[tuple[str, str], list[int]] = {}
    for slot, stratum, group, _ in plan.allocations:
        members.setdefault((stratum, group), []).append(slot)
    yield from _group_losses(plan)
    for (stratum, group), slots in members.items():
        trials = [plan.trials(slot) for slot in slots]
        where = " ".join(filter(None, (stratum, group)))
        for index, block in enumerate(_blocks(protocol)):
            own = [[one for one in line if one.block == index] for line in trials]
            for loss in _block_losses(plan, block, index, slots[0], own):
                yield f"{_place(protocol, where, index)}{loss}"


def _group_losses(plan: StudyPlan) -> Iterator[str]:
    sizes = Counter((stratum, group) for _, stratum, group, _ in plan.allocations)
    for stratum in dict.fromkeys(stratum for stratum, _ in sizes):
        least, most = spread(size for (other, _), size in sizes.items() if other == stratum)
        if least < most:
            yield f"{stratum + ': ' if stratum else ''}a group has {least} to {most} participants"


def _block_losses(
    plan: StudyPlan, block: Block, index: int, slot: int, trials: list[list[PlannedTrial]]
) -> Iterator[str]:
    if not isinstance(block.order, PlannedOrder):
        return
    sequences = [
        [str(trial.condition) for trial in line if trial.kind == block.kind] for line in trials
    ]
    yield from block.order.imbalance(plan.conditions(slot, index), sequences)
    met = Counter((one.kind, one.condition, one.route) for line in trials for one in line)
    routes = {trial.route for line in trials for trial in line}
    found = [spread(met[*cell, route] for route in routes) for cell in {key[:2] for key in met}]
    least, most = max(found, key=lambda pair: pair[1] - pair[0])
    if least < most:
        yield f"a condition meets a route {least} to {most} times"


def _place(protocol: Protocol, where: str, index: int) -> str:
    """Open a sentence with the group and the block, where there are several."""
    block = f"block {index + 1}" if len(_blocks(protocol)) > 1 else ""
    place = ", ".join(filter(None, (where, block)))
    return f"{place}: " if place else ""

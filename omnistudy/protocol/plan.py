"""A slot's trials in time: visit, kind, condition, repetition and route."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np

from omnistudy.protocol.allocation import allocations
from omnistudy.protocol.freeze import freeze
from omnistudy.protocol.groups import groups, met_in
from omnistudy.protocol.ordering.order import PastTrial, PlannedOrder, Seat
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.routes import spread_routes
from omnistudy.protocol.seeds import allocation_seed
from omnistudy.protocol.visit import Block
from omnistudy.seeds import seed_text


class PlannedTrial(NamedTuple):
    """One trial before it is run.

    position : 1-based place in the participant's order, counted through all visits.
    visit : 1-based. block : 0-based, counted through all visits.
    condition : None as long as an order that adapts has not chosen it.
    repetition : 1-based, how often the condition has come by then in trials of this kind.
    kind : "main" for the trials that answer the study's question.
    """

    position: int
    visit: int
    block: int
    condition: str | None
    repetition: int
    kind: str
    route: str


class StudyPlan:
    """Who meets what and when; it depends on the design, the study key and the slot alone.

    design_hash : the one that the study was first frozen with; None takes the protocol's own.
    """

    def __init__(self, protocol: Protocol, design_hash: str | None = None) -> None:
        self._protocol = protocol
        design = design_hash or freeze(protocol).design_hash
        self._seed = allocation_seed(design, protocol.participants.study_key)
        self.allocations = allocations(protocol, design)
        self._groups = {group.name: group for group in groups(protocol)}

    @cached_property
    def _blocks(self) -> tuple[tuple[int, Block], ...]:
        """Every block with its visit, 1-based."""
        return tuple(
            (number, block)
            for number, visit in enumerate(self._protocol.course, start=1)
            for block in visit.blocks
        )

    def trials(self, slot: int) -> tuple[PlannedTrial, ...]:
        """Give the trials of a slot."""
        seen: Counter[tuple[str, str | None]] = Counter()
        trials: list[PlannedTrial] = []
        for index, (visit, block) in enumerate(self._blocks):
            for kind, condition, route in self._block_trials(slot, index, block):
                seen[kind, condition] += 1
                trials.append(
                    PlannedTrial(
                        position=len(trials) + 1,
                        visit=visit,
                        block=index,
                        condition=condition,
                        repetition=1 if condition is None else seen[kind, condition],
                        kind=kind,
                        route=route,
                    )
                )
        return tuple(trials)

    def next_condition(self, slot: int, block: int, history: Sequence[PastTrial]) -> str | None:
        """Ask a block's order for its next condition, given what came of its trials so far."""
        order = self._blocks[block][1].order
        return order.next(self.conditions(slot, block), self._seat(slot, block), history)

    def conditions(self, slot: int, block: int) -> tuple[str, ...]:
        """Name the conditions that a slot meets in a block."""
        group = self._groups[self.allocations[slot].group]
        return met_in(self._protocol, self._blocks[block][1], group)

    def _seat(self, slot: int, block: int) -> Seat:
        _, stratum, group, row = self.allocations[slot]
        return Seat(row, seed_text(self._seed, stratum, group, block))

    def _block_trials(
        self, slot: int, index: int, block: Block
    ) -> list[tuple[str, str | None, str]]:
        seat, conditions = self._seat(slot, index), self.conditions(slot, index)
        ordered: Sequence[str | None] = (None,) * block.order.trials(conditions)
        if isinstance(block.order, PlannedOrder):
            ordered = block.order.sequence(conditions, seat)
        trials = [(block.kind, condition) for condition in ordered]
        if block.catch is not None:
            rng = seat.own("catch trials")
            for place in catch_places(len(trials), block.catch.trials, rng):
                trials.insert(place, ("catch", block.catch.condition))
        routes = spread_routes(
            block.routes or self._protocol.routes,
            [f"{kind} {condition}" for kind, condition in trials],
            seat.row,
            seat.own("routes"),
        )
        return [(*trial, route) for trial, route in zip(trials, routes, strict=True)]


def plan(protocol: Protocol, slot: int) -> tuple[PlannedTrial, ...]:
    """Give the trials of a slot of a protocol that is not frozen into a study."""
    return StudyPlan(protocol).trials(slot)


def catch_places(trials: int, catches: int, rng: np.random.Generator) -> tuple[int, ...]:
    """Draw before which of a block's trials its catch trials come, the last place first.

    Never before the first trial, never two in the same place; needs catches < trials.
    """
    drawn = rng.choice(np.arange(1, trials), size=catches, replace=False)
    return tuple(int(place) for place in np.sort(drawn)[::-1])

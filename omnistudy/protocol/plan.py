"""A slot's trials in time: condition, repetition and route."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from omnistudy.protocol.freeze import freeze
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.seeds import order_seed
from omnistudy.seeds import generator


class PlannedTrial(NamedTuple):
    """One trial before it is run.

    position : 1-based place in the participant's order.
    repetition : 1-based, how often this condition has come by then.
    kind : "main" for the trials that count.
    """

    position: int
    condition: str
    repetition: int
    kind: str
    route: str


def plan(protocol: Protocol, slot: int) -> tuple[PlannedTrial, ...]:
    """Give the trials of a slot; they depend on design, study key and slot alone."""
    seed = order_seed(freeze(protocol).design_hash, protocol.participants.study_key, slot)
    names = [condition.name for condition in protocol.conditions]
    conditions = protocol.order.sequence(names, slot, generator(seed, "conditions"))
    routes = shuffled_routes(protocol.routes, len(conditions), slot, generator(seed, "routes"))
    seen: Counter[str] = Counter()
    trials = []
    for position, (condition, route) in enumerate(zip(conditions, routes, strict=True), start=1):
        seen[condition] += 1
        trials.append(PlannedTrial(position, condition, seen[condition], "main", route))
    return tuple(trials)


def shuffled_routes(
    routes: Sequence[str], trials: int, slot: int, rng: np.random.Generator
) -> tuple[str, ...]:
    """Spread routes over trials so that their numbers differ by at most one, then shuffle.

    Which routes come once more moves on from slot to slot, so that no route is favoured over the
    whole study (Tyagi 2017, sec. 5.1 has ten trials on three routes).
    """
    spread = [routes[(slot * trials + index) % len(routes)] for index in range(trials)]
    return tuple(spread[index] for index in rng.permutation(trials))

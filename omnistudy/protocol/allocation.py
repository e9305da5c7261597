"""Allocation: which slot is in which group and takes which row of its orders."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from omnistudy.protocol.groups import groups
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.seeds import allocation_seed
from omnistudy.seeds import generator


class Allocation(NamedTuple):
    """A slot's place in the design.

    slot : 0-based place in the study.
    stratum, group : "" when there is only one.
    row : 0-based place among the slots of the same stratum and group.
    """

    slot: int
    stratum: str
    group: str
    row: int


def allocations(protocol: Protocol, design_hash: str) -> tuple[Allocation, ...]:
    """Allocate every slot; drawn from the design hash and the study key alone.

    Strata follow each other in the slots. In each the groups are dealt out in permuted blocks of
    twice their number (of their number where fewer slots are left), so that nobody can tell the
    next group from the last ones and no group is ever ahead by more than two.
    """
    names = [group.name for group in groups(protocol)]
    seed = allocation_seed(design_hash, protocol.participants.study_key)
    found: list[Allocation] = []
    for stratum, count in _strata(protocol):
        rows: Counter[str] = Counter()
        for group in _dealt(names, count, generator(seed, f"groups of stratum {stratum}")):
            found.append(Allocation(len(found), stratum, group, rows[group]))
            rows[group] += 1
    return tuple(found)


def _strata(protocol: Protocol) -> Sequence[tuple[str, int]]:
    people = protocol.participants
    return [(one.name, one.count) for one in people.strata] or [("", people.count)]


def _dealt(names: Sequence[str], count: int, rng: np.random.Generator) -> list[str]:
    dealt: list[str] = []
    while len(dealt) < count:
        whole = 2 * len(names)
        block = [*names, *names] if count - len(dealt) >= whole else list(names)
        dealt += [block[index] for index in rng.permutation(len(block))]
    return dealt[:count]

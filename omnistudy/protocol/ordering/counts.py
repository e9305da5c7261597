"""How often conditions stand where, and which follows which."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from itertools import pairwise, permutations

Sequences = Sequence[Sequence[str]]


def place_counts(
    conditions: Sequence[str], sequences: Sequences, block_length: int = 1
) -> Counter[tuple[str, int]]:
    """Count how often each condition stands in each place; a place is a block of trials."""
    firsts = [sequence[::block_length] for sequence in sequences]
    counts = Counter({(name, place): 0 for name in conditions for place in _places(firsts)})
    counts.update((name, place) for line in firsts for place, name in enumerate(line))
    return counts


def neighbour_counts(conditions: Sequence[str], sequences: Sequences) -> Counter[tuple[str, str]]:
    """Count how often each condition comes directly after each other one."""
    counts = Counter(dict.fromkeys(permutations(conditions, 2), 0))
    counts.update(
        (before, after)
        for sequence in sequences
        for before, after in pairwise(sequence)
        if before != after
    )
    return counts


def spread(counts: Iterable[int]) -> tuple[int, int]:
    """Give the least and the greatest count, (0, 0) of nothing."""
    found = list(counts) or [0]
    return min(found), max(found)


def _places(lines: Sequences) -> range:
    return range(max((len(line) for line in lines), default=0))

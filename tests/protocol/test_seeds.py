from __future__ import annotations

import hashlib
from itertools import product

from omnistudy.protocol import Protocol
from omnistudy.protocol.compose import compose_protocol
from omnistudy.protocol.seeds import allocation_seed, participant_seed, trial_seed


def test_a_trials_seed_is_the_digest_of_what_identifies_the_attempt() -> None:
    text = "\x1f".join(["d" * 64, "key", "3", "1", "7", "2"])
    assert trial_seed("d" * 64, "key", 3, 1, 7, 2) == hashlib.sha256(text.encode()).hexdigest()


def test_no_two_attempts_share_a_seed() -> None:
    numbers = list(product(range(4), range(1, 3), range(1, 5), range(1, 3)))
    assert len({trial_seed("d", "k", *four) for four in numbers}) == len(numbers)


def test_a_replacement_is_another_person() -> None:
    people = {participant_seed("k", slot, occupant) for slot in range(3) for occupant in (1, 2)}
    assert len(people) == 6


def test_orders_trials_and_people_are_drawn_apart() -> None:
    seeds = {
        allocation_seed("d", "k"),
        participant_seed("k", 0, 1),
        trial_seed("d", "k", 0, 1, 1, 1),
    }
    assert len(seeds) == 3


def test_both_published_protocols_meet_the_same_people(component: Protocol) -> None:
    stiffness = compose_protocol("utah2017_arm_stiffness")
    keys = [protocol.participants.participant_key for protocol in (component, stiffness)]
    assert keys[0] == keys[1]
    assert stiffness.participants.count == component.participants.count
    assert stiffness.participants.study_key != component.participants.study_key

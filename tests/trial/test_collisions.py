"""Collisions counted as the thesis's code does and debounced, on contacts written by hand."""

from __future__ import annotations

from omnistudy.channel import Event
from omnistudy.scene import NO_CONTACT, Contacts
from omnistudy.trial.collisions import CollisionCounter

HZ = 240
OFF = NO_CONTACT
NEAR = Contacts(clear=False)
"""Not touching, but within 5 mm of a wall that was touched."""


def touch(*walls: str) -> Contacts:
    return Contacts(walls=walls, clear=False)


class Story:
    """Contacts one after the other, each for a while."""

    def __init__(self, *parts: tuple[Contacts, float]) -> None:
        self.counter = CollisionCounter(HZ)
        self.events: list[Event] = []
        step = 0
        for contacts, seconds in parts:
            for _ in range(round(seconds * HZ)):
                step += 1
                self.events += self.counter.update(step / HZ, contacts)

    @property
    def counts(self) -> tuple[int, int]:
        """Debounced, legacy."""
        return self.counter.count, self.counter.legacy


def test_one_touch_is_one_collision_with_a_beginning_and_an_end() -> None:
    story = Story((OFF, 1.0), (touch("w"), 0.5), (OFF, 1.0))
    assert story.counts == (1, 1)
    assert [(event.kind, event.detail) for event in story.events] == [
        ("collision", "w"),
        ("collision_end", ""),
    ]
    begun, ended = (event.t for event in story.events)
    assert begun == 1.0 + 1 / HZ
    assert ended == 1.5 + 0.25
    assert not story.counter.colliding


def test_a_bounce_within_a_quarter_second_is_still_the_same_collision() -> None:
    story = Story((touch("w"), 0.1), (OFF, 0.2), (touch("w"), 0.1), (OFF, 0.2), (touch("w"), 0.1))
    assert story.counts == (1, 3)
    assert story.counter.colliding


def test_a_bounce_after_more_than_a_quarter_second_is_a_new_one() -> None:
    story = Story((touch("w"), 0.1), (OFF, 0.3), (touch("w"), 0.1), (OFF, 0.3))
    assert story.counts == (2, 2)
    assert [event.kind for event in story.events] == ["collision", "collision_end"] * 2


def test_sliding_from_wall_to_wall_is_one_either_way() -> None:
    story = Story((touch("a"), 0.5), (touch("a", "b"), 0.1), (touch("b"), 0.5), (OFF, 1.0))
    assert story.counts == (1, 1)


def test_within_the_release_gap_a_collision_stays_open() -> None:
    story = Story((touch("w"), 0.1), (NEAR, 2.0))
    assert story.counter.colliding
    assert story.counts == (1, 1)


def test_being_clear_must_last_a_quarter_second_without_a_break() -> None:
    story = Story((touch("w"), 0.1), (OFF, 0.2), (NEAR, 0.1), (OFF, 0.2))
    assert story.counter.colliding
    story = Story((touch("w"), 0.1), (OFF, 0.2), (NEAR, 0.1), (OFF, 0.3))
    assert not story.counter.colliding


def test_contact_time_is_time_in_touch_only() -> None:
    story = Story((touch("w"), 0.5), (NEAR, 1.0), (touch("w", "v"), 0.25), (OFF, 1.0))
    assert story.counter.contact_time == 0.75


def test_blocks_and_doors_are_no_collisions() -> None:
    story = Story((Contacts(others=("red", "door")), 1.0))
    assert story.counts == (0, 0)
    assert story.events == []

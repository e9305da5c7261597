"""Faults that lie between the fields of a protocol, found before anybody drives."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator
from itertools import chain
from typing import NamedTuple

from omnistudy.errors import nearest
from omnistudy.protocol.condition import Condition
from omnistudy.protocol.design_checks import (
    course_faults,
    place_faults,
    visit_faults,
)
from omnistudy.protocol.protocol import Protocol
from omnistudy.protocol.schedule import session_duration
from omnistudy.protocol.visit import Visit
from omnistudy.worlds import World
from omnistudy.worlds.check import check_world

WORLD_FAULTS_TOLD = 5
"""A robot that is too wide meets nearly every wall; nobody reads a hundred lines."""


class Check(NamedTuple):
    """One kind of fault: the fields that must be valid to look for it, and the look."""

    needs: tuple[str, ...]
    faults: Callable[[Protocol], Iterator[str]]


def cross_faults(protocol: Protocol, valid: Collection[str]) -> tuple[str, ...]:
    """Give every fault between the fields named in `valid`; others are not looked at."""
    looks = [check.faults(protocol) for check in CHECKS if set(check.needs) <= set(valid)]
    return tuple(chain.from_iterable(looks))


def session_faults(protocol: Protocol) -> tuple[str, ...]:
    """Tell when a session is longer than its limit; needs a protocol without other faults."""
    longest = protocol.session.longest
    expected = session_duration(protocol)
    if expected <= longest:
        return ()
    return (
        f"session.longest: a session is expected to last {expected:.0f} s, the limit is "
        f"{longest:.0f} s: fewer trials, shorter routes or shorter pauses",
    )


def _labels(protocol: Protocol) -> Iterator[str]:
    labels = Counter(condition.masked_label for condition in protocol.conditions)
    for label, times in labels.items():
        if times > 1:
            yield f"conditions: {times} conditions share the masked_label '{label}': make it unique"


def _levels(protocol: Protocol) -> Iterator[str]:
    factors = {factor.name: factor.levels for factor in protocol.factors}
    for condition in protocol.conditions:
        where = f"conditions.{condition.name}.levels"
        levels = {level.factor: level.level for level in condition.levels}
        for factor in factors.keys() - levels.keys():
            yield f"{where}: no level of factor '{factor}': one of {', '.join(factors[factor])}"
        for factor, level in levels.items():
            if factor not in factors:
                names = ", ".join(factors) or "none"
                yield (
                    f"{where}.{factor}: unknown factor: the factors are {names}"
                    f"{nearest(factor, factors)}"
                )
            elif level not in factors[factor]:
                yield (
                    f"{where}.{factor}: unknown level '{level}': the levels are "
                    f"{', '.join(factors[factor])}{nearest(level, factors[factor])}"
                )


def _routes(protocol: Protocol) -> Iterator[str]:
    for world in _worlds(protocol):
        names = [route.name for route in world.routes]
        for given in _routes_named(protocol):
            if given not in names:
                yield (
                    f"routes: world '{world.name}' has no route '{given}': its routes are "
                    f"{', '.join(names)}{nearest(given, names)}"
                )


def _routes_named(protocol: Protocol) -> tuple[str, ...]:
    own = [block.routes for visit in _sound_visits(protocol) for block in visit.blocks]
    return tuple(dict.fromkeys((*protocol.routes, *chain.from_iterable(own))))


def _drivable(protocol: Protocol) -> Iterator[str]:
    setups = [
        (protocol.world, protocol.plant),
        *(
            (own.world or protocol.world, own.plant or protocol.plant)
            for own in _sound_conditions(protocol)
        ),
    ]
    for world, plant in {repr(setup): setup for setup in setups}.values():
        driven = tuple(route for route in world.routes if route.name in _routes_named(protocol))
        if driven:
            checked = check_world(
                world.model_copy(update={"routes": driven}), plant.width, plant.circumradius
            )
            yield from (f"world: {fault}" for fault in checked.faults[:WORLD_FAULTS_TOLD])
            if len(checked.faults) > WORLD_FAULTS_TOLD:
                more = len(checked.faults) - WORLD_FAULTS_TOLD
                yield f"world: {more} more; `omnistudy world check {world.name}` tells them all"


def _participants(protocol: Protocol) -> Iterator[str]:
    people = protocol.participants
    keys = {"study_key": people.study_key, "participant_key": people.participant_key}
    for name, key in keys.items():
        if people.kind == "virtual" and not key:
            yield f"participants.{name}: virtual participants need one: any text that stays"
        if people.kind == "human" and key:
            yield f"participants.{name}: a human study's key lies in its vault: leave it out"


def _ethics(protocol: Protocol) -> Iterator[str]:
    ethics, kind = protocol.site.ethics, protocol.participants.kind
    if ethics.status == "not_needed" and kind == "human":
        yield "site.ethics.status: people take part only under an approval: status approved"
    if ethics.status == "not_needed" and not ethics.note:
        yield "site.ethics.note: say why no approval is needed"
    if ethics.status == "approved" and not (ethics.board and ethics.number):
        yield "site.ethics: an approval needs its board and its number"


def _screen(protocol: Protocol) -> Iterator[str]:
    messages = protocol.messages
    if protocol.participants.kind != "human":
        return
    for part in ("screen", "pages"):
        if getattr(messages, part) is None:
            yield (
                f"messages.{part}: people look at a screen, and its sentences are missing in "
                f"language '{messages.language}': translate those of conf/messages/en.yaml"
            )


def _block_words(protocol: Protocol) -> Iterator[str]:
    messages = protocol.messages
    if protocol.participants.kind != "human":
        return
    worded = {block.name for block in messages.blocks}
    for world in _worlds(protocol):
        legs = chain.from_iterable(route.legs for route in world.routes)
        for target in dict.fromkeys(leg.target for leg in legs):
            if target not in worded:
                yield (
                    f"messages.blocks.{target}: world '{world.name}' has this block, and language "
                    f"'{messages.language}' has no word for it: colours alone tell some people "
                    "nothing"
                )


def _worlds(protocol: Protocol) -> tuple[World, ...]:
    own = [condition.world or protocol.world for condition in _sound_conditions(protocol)]
    return tuple({repr(world): world for world in (protocol.world, *own)}.values())


def _sound_visits(protocol: Protocol) -> tuple[Visit, ...]:
    return protocol.visits if "visits" in protocol.model_fields_set else ()


def _sound_conditions(protocol: Protocol) -> tuple[Condition, ...]:
    """Give the conditions, or none when they are faulty, so that the rest is looked at."""
    return protocol.conditions if "conditions" in protocol.model_fields_set else ()


CHECKS = (
    Check(("conditions",), _labels),
    Check(("factors", "conditions"), _levels),
    Check(("order", "visits", "factors", "conditions"), course_faults),
    Check(("visits",), visit_faults),
    Check(("participants", "factors", "conditions"), place_faults),
    Check(("world", "routes"), _routes),
    Check(("world", "plant", "routes"), _drivable),
    Check(("participants",), _participants),
    Check(("site", "participants"), _ethics),
    Check(("messages", "participants"), _screen),
    Check(("messages", "participants", "world"), _block_words),
)
"""Everything that is looked for, in the order of the page."""

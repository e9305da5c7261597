"""From the words of the command line to a sweep: points, thinned trials, seeds."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from pydantic import ValidationError

from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.errors.sweep import (
    AdaptiveOrder,
    BadSweepName,
    HumanSweep,
    KeyChangesNothing,
    NothingToSearch,
    NoTrialsOfConditions,
    SearchNeedsSamples,
    TooManyParticipants,
)
from omnistudy.protocol import FrozenProtocol, Protocol, freeze, plan
from omnistudy.protocol.seeds import participant_seed, trial_seed
from omnistudy.seeds import seed_text
from omnistudy.session.sweep.effects import Composer, Effects, canonical_tree, changed
from omnistudy.session.sweep.points import combinations, require_interval
from omnistudy.session.sweep.question import Point, Search, Sweep, SweptTrial
from omnistudy.session.sweep.variables import Asked, override_text, read_words
from omnistudy.version import VERSION

KINDS = ("main", "retention")
"""Kinds of trials that answer the study's question; others are not driven."""

FIRST_OCCUPANT = 1
FIRST_ATTEMPT = 1


@dataclass(frozen=True, slots=True)
class Thinning:
    """How much of the protocol each point drives.

    conditions : none means those that the swept design keys change (without a design key: any).
    participants : the first so many; None for all. trials : the first so many of each.
    """

    conditions: tuple[str, ...] = ()
    participants: int | None = None
    trials: int | None = None


@dataclass(frozen=True, slots=True)
class Question:
    """What is asked of a sweep.

    words : KEY=VALUES as typed. nuisance, design : keys that change their role.
    samples : of the design's intervals. nuisance_samples : of the nuisance's; None: as many.
    objective : column to be made small by a search; None lists every point.
    """

    protocol: str
    words: tuple[str, ...]
    nuisance: tuple[str, ...] = ()
    design: tuple[str, ...] = ()
    samples: int | None = None
    nuisance_samples: int | None = None
    seed: str = "sweep"
    thinning: Thinning = Thinning()
    objective: str | None = None


@dataclass(frozen=True)
class PointMaker:
    """Makes points of a base protocol out of values."""

    keys: tuple[str, ...]
    tree: Mapping[str, Any]
    effects: Effects
    composer: Composer

    def at(self, values: Mapping[str, Any], design: int, nuisance: int) -> Point:
        """Give the point at these values, validated; raises ProtocolFaults."""
        ordered = {key: values[key] for key in self.keys if key in values}
        changes = self.effects.changes(ordered)
        try:
            changed(self.tree, changes)
        except ValidationError:
            # Composing says the same in words.
            self.composer.protocol(ordered)
            raise
        return Point(
            design=design, nuisance=nuisance, values=tuple(ordered.values()), changes=changes
        )


@dataclass(frozen=True)
class SweepPlan:
    """A sweep with what a search needs to go on asking."""

    sweep: Sweep
    asked: Asked
    points: PointMaker


def plan_sweep(
    question: Question, planned: Callable[[int], None] = lambda total: None
) -> SweepPlan:
    """Compose the base, read the words, list points and trials.

    planned : told of every point that is planned, of how many in all.

    Raises ProtocolFaults, UnknownCondition, and every mistake of `errors.sweep` that lies in what
    was asked.
    """
    asked = read_words(question.words, question.nuisance, question.design)
    search = _search(question, asked)
    composer, base = _based(question.protocol, asked)
    if base.participants.kind != "virtual":
        raise HumanSweep(base.name)
    frozen = freeze(base)
    effects = Effects(composer, base, asked.swept)
    keys = tuple(one.variable.key for one in asked.swept)
    maker = PointMaker(keys, canonical_tree(frozen), effects, composer)
    touched = {key: _touched(base, effects.ends(key)) for key in keys}
    conditions = _conditions(base, touched, asked, question.thinning.conditions)
    trials = _trials(base, frozen, conditions, question.thinning)
    _require_effect(touched, list(dict.fromkeys(trial.condition for trial in trials)))
    sweep = Sweep(
        version=VERSION,
        protocol=question.protocol,
        overrides=composer.overrides,
        design_hash=frozen.design_hash,
        site_hash=frozen.site_hash,
        base=dict(maker.tree),
        variables=tuple(one.variable for one in asked.swept),
        samples=question.samples,
        nuisance_samples=question.nuisance_samples,
        seed=question.seed,
        conditions=conditions,
        trials=trials,
        points=_points(question, asked, maker, planned),
        search=search,
    )
    return SweepPlan(sweep, asked, maker)


def sweep_name(sweep: Sweep, given: str | None) -> str:
    """Give a sweep's name: the one given, else protocol and hash of what is asked.

    Raises BadSweepName.
    """
    name = given
    if name is None:
        protocol = re.sub(r"[^A-Za-z0-9_-]", "_", str(sweep.base["name"]))
        name = f"{protocol}_{seed_text(sweep.model_dump_json())[:8]}"
    if not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_-]*", name):
        raise BadSweepName(name)
    return name


def _points(
    question: Question,
    asked: Asked,
    maker: PointMaker,
    planned: Callable[[int], None],
) -> tuple[Point, ...]:
    """List every point; for a search the nuisance alone, as design 0."""
    nuisance_samples = question.nuisance_samples or question.samples
    nuisances = combinations(asked.swept, "nuisance", nuisance_samples, question.seed)
    if question.objective is not None:
        return tuple(maker.at(met, 0, number) for number, met in enumerate(nuisances, start=1))
    require_interval(asked.swept, question.samples)
    designs = combinations(asked.swept, "design", question.samples, question.seed)
    points: list[Point] = []
    for design, chosen in enumerate(designs, start=1):
        for nuisance, met in enumerate(nuisances, start=1):
            points.append(maker.at({**chosen, **met}, design, nuisance))
            planned(len(designs) * len(nuisances))
    return tuple(points)


def _based(protocol: str, asked: Asked) -> tuple[Composer, Protocol]:
    """Give what composes points, and the base.

    The base has the protocol's own values, so that sweeps over other lists meet the same seeds; a
    page that leaves a swept key open, such as the file of a recording, has the first ones.
    """
    plain = Composer(protocol, asked.overrides)
    try:
        return plain, plain.protocol({})
    except ProtocolFaults as fault:
        firsts = [override_text(one.variable.key, one.ends[0]) for one in asked.swept]
        filled = Composer(protocol, (*asked.overrides, *firsts))
        try:
            return filled, filled.protocol({})
        except ProtocolFaults:
            raise fault from None


def _search(question: Question, asked: Asked) -> Search | None:
    if question.objective is None:
        return None
    if question.samples is None:
        raise SearchNeedsSamples
    if not any(one.variable.role == "design" for one in asked.swept):
        raise NothingToSearch
    return Search(objective=question.objective, samples=question.samples)


def _conditions(
    base: Protocol, touched: Mapping[str, set[str]], asked: Asked, given: Sequence[str]
) -> tuple[str, ...]:
    """Name the conditions to drive: those given, else those that the design keys change."""
    names = [condition.name for condition in base.conditions]
    for name in given:
        base.condition(name)
    designs = [one.variable.key for one in asked.swept if one.variable.role == "design"]
    by_keys = set().union(*(touched[key] for key in designs or touched))
    return tuple(name for name in names if name in (given or by_keys or names))


def _require_effect(touched: Mapping[str, set[str]], conditions: Sequence[str]) -> None:
    """Raise KeyChangesNothing for a key that changes none of the conditions driven."""
    for key, changed_ones in touched.items():
        if not changed_ones & set(conditions):
            raise KeyChangesNothing(key, conditions)


def _touched(base: Protocol, protocols: Iterable[Protocol]) -> set[str]:
    """Name the conditions whose set-up differs in one of some protocols."""
    return {
        condition.name
        for condition in base.conditions
        for protocol in protocols
        if protocol.setup_for(condition.name) != base.setup_for(condition.name)
    }


def _trials(
    base: Protocol, frozen: FrozenProtocol, conditions: Sequence[str], thinning: Thinning
) -> tuple[SweptTrial, ...]:
    """Take the base protocol's own plan and seeds, thinned: every point meets the same."""
    people = base.participants
    count = thinning.participants or people.count
    if count > people.count:
        raise TooManyParticipants(count, people.count)
    trials = []
    for slot in range(count):
        person = participant_seed(people.participant_key, slot, FIRST_OCCUPANT)
        for trial in list(_met(base, slot, conditions))[: thinning.trials]:
            seed = trial_seed(
                frozen.design_hash,
                people.study_key,
                slot,
                FIRST_OCCUPANT,
                trial.position,
                FIRST_ATTEMPT,
            )
            trials.append(
                SweptTrial(
                    participant=f"P{slot + 1:02d}",
                    participant_seed=person,
                    position=trial.position,
                    kind=trial.kind,
                    condition=str(trial.condition),
                    repetition=trial.repetition,
                    route=trial.route,
                    seed=seed,
                )
            )
    if not trials:
        raise NoTrialsOfConditions(conditions, count)
    return tuple(trials)


def _met(base: Protocol, slot: int, conditions: Sequence[str]) -> Iterable[Any]:
    """Give a slot's trials that are to be driven; raises AdaptiveOrder."""
    planned = plan(base, slot)
    if any(trial.condition is None for trial in planned):
        raise AdaptiveOrder(base.name)
    return (one for one in planned if one.kind in KINDS and one.condition in conditions)

"""A sweep as one frozen value: what is asked, which points there are, which trials each drives."""

from __future__ import annotations

from typing import Any, Literal

from omnistudy.registry import Model

Role = Literal["design", "nuisance"]
"""What one may choose, such as a gain, or what one meets, such as an arm."""


class Variable(Model):
    """A key that is swept."""

    key: str
    """Dotted, as in `omnistudy protocol check`."""
    role: Role
    asked: str
    """Values as they were typed, in Hydra's grammar."""


class Change(Model):
    """One place of the protocol's canonical tree that differs from the base."""

    path: tuple[str | int, ...]
    value: Any


class Point(Model):
    """One setting of every variable.

    design, nuisance : which combination of either role, 1-based.
    values : in the order of the sweep's variables.
    """

    design: int
    nuisance: int
    values: tuple[Any, ...]
    changes: tuple[Change, ...]


class SweptTrial(Model):
    """A trial that every point drives: person, place in the order and seed come from the base."""

    participant: str
    participant_seed: str
    position: int
    kind: str
    condition: str
    repetition: int
    route: str
    seed: str


class Search(Model):
    """Design points that are not listed but asked for, one after the other."""

    objective: str
    """Column of the table whose mean over nuisance and participants is made small."""
    samples: int


class Sweep(Model):
    """Everything that decides a sweep's table, but the code."""

    version: str
    """Of omnistudy."""
    protocol: str
    """Name or file, as it was given."""
    overrides: tuple[str, ...]
    """What was given one value, for every point alike; swept keys that the page leaves open."""
    design_hash: str
    site_hash: str
    base: dict[str, Any]
    """The protocol's canonical tree."""
    variables: tuple[Variable, ...]
    samples: int | None
    nuisance_samples: int | None
    seed: str
    conditions: tuple[str, ...]
    trials: tuple[SweptTrial, ...]
    points: tuple[Point, ...]
    """In a search the nuisance alone, as design 0; each design point asked for meets all of it."""
    search: Search | None = None

    def keys(self, role: Role) -> tuple[str, ...]:
        """Name the variables of a role."""
        return tuple(variable.key for variable in self.variables if variable.role == role)

    @property
    def driven(self) -> tuple[str, ...]:
        """Name the conditions that are really driven, thinned as they are."""
        return tuple(dict.fromkeys(trial.condition for trial in self.trials))

    @property
    def nuisances(self) -> int:
        """Count the combinations of the nuisance, which every design point meets."""
        return len({point.nuisance for point in self.points})

    @property
    def designs(self) -> int:
        """Count the design points, in a search those that it may try."""
        return self.search.samples if self.search else len({one.design for one in self.points})

"""SYNTHETIC studies: numbers drawn from a seed, not trials that anybody or any model drove."""

from dataclasses import dataclass

import numpy as np
import pandas as pd

from omnistudy.analysis.arm_stiffness import FACTOR
from omnistudy.analysis.tables import StudyTables
from omnistudy.analysis.utah2017 import CONDITIONS
from omnistudy.channel import SAMPLE_COLUMNS
from omnistudy.scene import Body, Box, Region
from omnistudy.seeds import generator, seed_text
from omnistudy.worlds import Leg, Route, Start, World

SEED = seed_text("synthetic report")
PLACES = (
    *(("none", n) for n in (1, 2, 3)),
    *(("full", n) for n in (1, 2, 3)),
    *((name, 1) for name in CONDITIONS[2:]),
)
COLUMNS = (
    "trial",
    "participant",
    "visit",
    "position",
    "attempt",
    "condition",
    "repetition",
    "route",
    "status",
    "duration_s",
    "collisions",
    "collisions_legacy",
)


@dataclass(frozen=True)
class Synthetic:
    """Makes tables of studies that were never driven."""

    def world(self) -> World:
        wall = Box(x=4.0, y=0.1, z=0.8)
        return World(
            name="synthetic",
            start=Start(x=0.0, y=0.0),
            bodies=(
                Body(name="north", role="wall", geometry=wall, x=2.0, y=0.6, z=0.4),
                Body(name="south", role="wall", geometry=wall, x=2.0, y=-0.6, z=0.4),
                Body(
                    name="finish",
                    role="finish",
                    geometry=Box(x=0.2, y=0.2, z=0.2),
                    x=3.5,
                    y=0.0,
                    z=0.1,
                    colour="#2a5caa",
                ),
            ),
            regions=(
                Region(
                    name="part",
                    polygon=((1.0, -1.0), (3.0, -1.0), (3.0, 1.0), (1.0, 1.0)),
                    group="green",
                ),
            ),
            routes=(Route(name="there", legs=(Leg(target="finish", path=((0, 0), (3.5, 0))),)),),
        )

    def samples(self, trial: int) -> pd.DataFrame:
        t = np.arange(0.0, 12.0, 0.05)
        rng = generator(SEED, f"samples {trial}")
        rows = np.zeros((len(t), len(SAMPLE_COLUMNS)))
        rows[:, 0] = t
        rows[:, 1] = 0.3 * t
        rows[:, 2] = 0.15 * np.sin(t + rng.uniform(0, 6))
        rows[:, 10:12] = rng.normal(0, 3, (len(t), 2))
        rows[:, 12] = rng.normal(0, 0.4, len(t))
        return pd.DataFrame(rows, columns=list(SAMPLE_COLUMNS))

    def published(self, people: int = 8) -> StudyTables:
        rng = generator(SEED, "published")
        rows = []
        for person in range(1, people + 1):
            skill = rng.lognormal(0.0, 0.45)
            for position, (condition, repetition) in enumerate(PLACES, start=1):
                level = (30.0 if condition == "none" else 5.0) * skill * position**-0.2
                count = int(rng.poisson(level))
                status = "timed_out" if person == 3 and position == 9 else "completed"
                rows.append(
                    (
                        len(rows) + 1,
                        f"P{person:02d}",
                        1,
                        position,
                        1,
                        condition,
                        repetition,
                        "there",
                        status,
                        90.0 + 1.5 * count + rng.normal(0, 4),
                        count,
                        count + int(rng.poisson(1)),
                    )
                )
        return self.tables("synthetic_utah2017", rows, CONDITIONS)

    def arms(self, people: int = 8) -> StudyTables:
        rng = generator(SEED, "arms")
        quantiles = (0.05, 0.25, 0.5, 0.75, 0.95)
        names = tuple(f"arm_q{round(100 * quantile):02d}" for quantile in quantiles)
        rows = []
        for person in range(1, people + 1):
            for position, (name, quantile) in enumerate(zip(names, quantiles, strict=True), 1):
                count = int(rng.poisson(1.0 + 12.0 * quantile**2))
                rows.append(
                    (
                        len(rows) + 1,
                        f"P{person:02d}",
                        1,
                        position,
                        1,
                        name,
                        1,
                        "there",
                        "completed",
                        100.0 + count,
                        count,
                        count,
                    )
                )
        tables = self.tables("synthetic_arms", rows, names, (FACTOR,))
        levels = {name: str(quantile) for name, quantile in zip(names, quantiles, strict=True)}
        tables.trials[FACTOR] = tables.trials["condition"].map(levels)
        return tables

    def tables(
        self,
        name: str,
        rows: list[tuple[object, ...]],
        conditions: tuple[str, ...],
        factors: tuple[str, ...] = (),
        kind: str = "virtual",
    ) -> StudyTables:
        trials = pd.DataFrame(rows, columns=list(COLUMNS))
        return StudyTables(
            name=name,
            title="A synthetic study",
            kind=kind,
            design_hash=seed_text(name, "design"),
            site_hash=seed_text(name, "site"),
            made_by="0.1.0",
            trials=trials,
            events=pd.DataFrame(
                [
                    (trial, 2.0 + n, "collision", "north")
                    for trial, count in zip(trials["trial"], trials["collisions"], strict=True)
                    for n in range(int(count) if count == count else 0)
                ],
                columns=["trial", "t", "kind", "detail"],
            ),
            participants=pd.DataFrame(
                {"participant": sorted(trials["participant"].unique()), "kind": kind}
            ),
            conditions=conditions,
            samples=self.samples,
            world=self.world(),
            factors=factors,
        )

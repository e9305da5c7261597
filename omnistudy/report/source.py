"""From a study file to the tables that analysis reads."""

from __future__ import annotations

from omnistudy.analysis.tables import Exclusion, StudyTables
from omnistudy.protocol.freeze import thaw
from omnistudy.protocol.protocol import Protocol
from omnistudy.store.study_file import StudyFile
from omnistudy.worlds import World

MAIN = "main"
"""Kind of the trials that count; training is not reported."""
NO_FACTOR = ("condition", "masked_label")


def study_tables(study: StudyFile) -> StudyTables:
    """Read what a report needs; samples are read one trial at a time, while `study` is open."""
    protocol = thaw(study.study.protocol_json)
    trials = study.trials()
    trials = trials[trials["kind"] == MAIN]
    exclusions = tuple(Exclusion(*row) for row in study.exclusions().itertuples(index=False))
    left_out = {exclusion.trial for exclusion in exclusions}
    return StudyTables(
        name=study.study.name,
        title=study.study.title,
        kind=study.study.kind,
        design_hash=study.study.design_hash,
        site_hash=study.study.site_hash,
        made_by=study.study.omnistudy_version,
        trials=trials[~trials["trial"].isin(left_out)],
        events=study.events(),
        participants=study.participants(),
        conditions=tuple(condition.name for condition in protocol.conditions),
        samples=study.samples,
        world=_one_world(protocol),
        factors=tuple(name for name in study.conditions().columns if name not in NO_FACTOR),
        exclusions=tuple(one for one in exclusions if one.trial in set(trials["trial"])),
    )


def _one_world(protocol: Protocol) -> World | None:
    """Give the world if all conditions are driven in the same one."""
    worlds = [protocol.setup_for(condition.name).world for condition in protocol.conditions]
    return worlds[0] if all(world == worlds[0] for world in worlds) else None

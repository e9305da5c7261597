"""Amending a frozen protocol: texts and site may change, the design and its allocation never."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from omnistudy.errors.study import DesignChanged, NothingAmended
from omnistudy.protocol import Protocol, freeze
from omnistudy.protocol.diff import Difference, diff
from omnistudy.store import NewStudy, StudyRecord, StudyWriter
from omnistudy.study.create import new_conditions


@dataclass(frozen=True, slots=True)
class Amendment:
    """What an amendment changes; `version` is the one that it makes."""

    study: str
    version: int
    differences: tuple[Difference, ...]


def amendment(study: StudyRecord, protocol: Protocol) -> Amendment:
    """Say what a protocol would amend; raises DesignChanged or NothingAmended."""
    frozen = freeze(protocol)
    differences = diff(study.protocol_json, frozen.canonical_json)
    if frozen.design_hash != study.design_hash:
        raise DesignChanged(study.name, differences)
    if not differences:
        raise NothingAmended(study.name)
    return Amendment(study.name, study.protocol_version + 1, differences)


def amend_study(path: Path, protocol: Protocol, reason: str) -> Amendment:
    """Amend a study; nothing is drawn again, and what was run keeps the version it was run with.

    Raises DesignChanged, NothingAmended, and what the store raises.
    """
    with StudyWriter.open(path) as writer:
        study = writer.study
        made = amendment(study, protocol)
        frozen = freeze(protocol)
        writer.amend(
            NewStudy(
                name=study.name,
                title=protocol.title,
                kind=study.kind,
                protocol_json=frozen.canonical_json,
                protocol_version=made.version,
                design_hash=frozen.design_hash,
                site_hash=frozen.site_hash,
            ),
            new_conditions(protocol),
            reason,
        )
        return made

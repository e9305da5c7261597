"""The protocol that a study was frozen with, and that nothing else is run under its name."""

from __future__ import annotations

import json

from omnistudy.errors.study import ProtocolChanged
from omnistudy.protocol import Protocol, freeze
from omnistudy.protocol.compose import read_protocol
from omnistudy.protocol.diff import diff
from omnistudy.store import StudyRecord


def frozen_protocol(study: StudyRecord) -> Protocol:
    """Give the frozen protocol back.

    Raises ProtocolFaults when this installation cannot read it, such as for want of a kind.
    """
    return read_protocol(json.loads(study.protocol_json), f"the frozen protocol of '{study.name}'")


def check_unchanged(study: StudyRecord, protocol: Protocol) -> None:
    """Raise ProtocolChanged, with what differs, unless the protocol is the frozen one."""
    given = freeze(protocol).canonical_json
    if given != study.protocol_json:
        raise ProtocolChanged(study.name, diff(study.protocol_json, given))

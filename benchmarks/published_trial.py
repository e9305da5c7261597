"""One trial of the published study, as every part of the benchmark runs it."""

from __future__ import annotations

import hashlib
import resource
import subprocess
import sys
import time
from typing import NamedTuple

from omnistudy.operators import Person
from omnistudy.protocol.compose import compose_protocol
from omnistudy.seeds import seed_text
from omnistudy.session.specs import coupled
from omnistudy.trial import TrialResult, TrialSpec, run_trial


def published_trial() -> TrialSpec:
    """Give a trial with full feedback of the first virtual participant."""
    protocol = compose_protocol("utah2017_component")
    person = Person(seed_text("benchmark", "person"), seed_text("benchmark", "trial"), 1)
    return coupled(protocol, "full", protocol.routes[0], person)


def digest(result: TrialResult) -> str:
    """Give SHA-256 over samples and streams."""
    total = hashlib.sha256(result.samples.tobytes())
    for stream in result.streams:
        total.update(stream.data.tobytes())
    return total.hexdigest()


def simulated_seconds(result: TrialResult) -> float:
    """Give how much time passed in the trial, from its opening to its end."""
    steps = next(stream for stream in result.streams if stream.name == "input")
    return len(steps.data) / steps.rate_hz


def speed(spec: TrialSpec) -> float:
    """Run a trial; give how many simulated seconds passed in one, recording on."""
    began = time.perf_counter()
    result = run_trial(spec)
    return simulated_seconds(result) / (time.perf_counter() - began)


class OwnProcess(NamedTuple):
    """What a process that ran the trial alone tells of itself."""

    digest: str
    peak_megabytes: float


def in_own_process() -> OwnProcess:
    """Run the trial in a process of its own."""
    ran = subprocess.run([sys.executable, __file__], stdout=subprocess.PIPE, text=True, check=True)
    found, peak = ran.stdout.split()
    return OwnProcess(found, float(peak))


def peak_megabytes() -> float:
    """Give the largest resident memory this process has had, MB."""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return peak / (1024 * 1024 if sys.platform == "darwin" else 1024)


if __name__ == "__main__":
    print(digest(run_trial(published_trial())), peak_megabytes())

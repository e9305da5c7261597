"""The same trials with the simulated stick and through the firmware: collisions of each.

Ten virtual participants drive the published study's first route with full feedback. Seeds differ,
the two sticks of a seed share everything else. In lockstep about twenty minutes on two cores. With
--live the firmware runs in real time in a process of its own, as in a session: a worker then needs
half a core, and the machine should do nothing else.
"""

from __future__ import annotations

import argparse
import json
import statistics
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from typing import NamedTuple

from stick_live import Pace

from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.real_time import before_others
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.operators import Person
from omnistudy.protocol.compose import compose_protocol
from omnistudy.seeds import seed_text
from omnistudy.session.specs import coupled
from omnistudy.trial import TrialResult, TrialSpec, run_trial

PROTOCOL, CONDITION = "utah2017_component", "full"
ALLOWED = 0.2
"""Of the simulated stick's median; one collision is always allowed (issue 6)."""
MOST_VOIDS = 3


class Driven(NamedTuple):
    """One trial of one stick; `voids` are the reasons of the attempts before it."""

    seed: int
    device: str
    status: str
    duration_s: float
    collisions: int
    voids: list[str]


def spec(seed: int, device: str, attempt: int) -> TrialSpec:
    protocol = compose_protocol(PROTOCOL)
    again = f", attempt {attempt}" if attempt > 1 else ""
    person = Person(
        seed_text("stick collisions", f"person {seed}"),
        seed_text("stick collisions", f"trial {seed}{again}"),
        1,
    )
    coupling = coupled(protocol, CONDITION, protocol.routes[0], person)
    stick = SimulatedStick() if device == "simulated_stick" else EmulatedStickDevice()
    return replace(coupling, device=stick)


def live(trial: TrialSpec) -> TrialResult:
    """Drive in real time with the device in a process of its own."""
    with RemoteDevice(trial.device) as held, before_others():
        held.open_trial(1)
        result = run_trial(trial, Pace(), held)
        held.close_trial()
        return result


def drive(seed: int, device: str, in_real_time: bool) -> Driven:
    """Drive as a session does: what is void has another attempt."""
    run = live if in_real_time and device == "emulated_stick" else run_trial
    voids: list[str] = []
    while True:
        result = run(spec(seed, device, len(voids) + 1))
        if result.status != "void" or len(voids) == MOST_VOIDS:
            seconds = round(result.duration_s or 0.0, 1)
            return Driven(seed, device, result.status, seconds, result.collisions, voids)
        voids.append(result.reason)


def medians(driven: list[Driven]) -> dict[str, float]:
    devices = sorted({one.device for one in driven})
    return {
        device: statistics.median(one.collisions for one in driven if one.device == device)
        for device in devices
    }


def agrees(found: dict[str, float]) -> bool:
    """Tell whether the medians differ by at most one or 20 %."""
    apart = abs(found["emulated_stick"] - found["simulated_stick"])
    return apart <= max(1.0, ALLOWED * found["simulated_stick"])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seeds", type=int, default=10)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--live", action="store_true")
    given = parser.parse_args()
    wanted = [
        (seed, device, given.live)
        for seed in range(1, given.seeds + 1)
        for device in ("emulated_stick", "simulated_stick")
    ]
    with ProcessPoolExecutor(given.workers) as pool:
        driven = []
        for one in pool.map(drive, *zip(*wanted, strict=True)):
            driven.append(one)
            print(json.dumps(one._asdict()), flush=True)
    found = medians(driven)
    print(json.dumps({"medians": found, "agrees": agrees(found)}))


if __name__ == "__main__":
    main()

"""A live trial against the emulated stick: how late, how old, how soon drawn. Wall time.

The board runs in the device's process as in a session; a virtual hand holds it, PyBullet simulates
beside it. Once with real-time scheduling where the system gives it, once without.
"""

from __future__ import annotations

import ctypes
import json
import re
import resource
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

from omnistudy.devices import Device, DeviceState, Hand
from omnistudy.devices.emulated_stick import EmulatedStickDevice
from omnistudy.devices.real_time import before_others, real_time_means
from omnistudy.devices.remote_device import RemoteDevice
from omnistudy.geometry import NO_FORCE, ForceField, PlanarWrench
from omnistudy.operators import Person
from omnistudy.protocol.compose import compose_protocol
from omnistudy.seeds import seed_text
from omnistudy.session.live import RealTime
from omnistudy.session.specs import coupled
from omnistudy.trial import Glimpse, TrialSpec, run_trial

SHORT = ("world=primitive_c", "routes=[through]", "participants.count=1", "order.block_length=1")
"""A trial of about twenty seconds."""
FIELDS = 100
GRIP = Hand((0.0,) * 3, (1_000.0, 1_000.0, 20.0), (50.0, 50.0, 0.5), (0.3, 0.3, 0.0015))
FELT = 0.25
"""N: more than centring changes by while the handle settles, less than two ticks of a new field."""
CAP_SYS_NICE, PR_CAPBSET_DROP = 23, 24
"""Of capabilities(7) and prctl(2)."""


class Pace(RealTime):
    """The wall clock's pace, and nobody who looks or stops."""

    def see(self, glimpse: Glimpse) -> None:
        """Show nothing."""

    def end(self, status: str) -> None:
        """Show nothing."""

    @property
    def stopped(self) -> bool:
        """Never."""
        return False


class Timed(RemoteDevice):
    """Tells how old what a field was computed from was when the field was ordered."""

    def __init__(self, device: Device) -> None:
        super().__init__(device)
        self.ages: list[float] = []
        self._heard_at = 0.0

    def advance(self, hand: Hand) -> DeviceState:
        """Give the state, and remember when the device's process told it."""
        state = super().advance(hand)
        self._heard_at = self._report.time
        return state

    def render(self, field: ForceField) -> None:
        """Order the field."""
        super().render(field)
        if self._heard_at:
            self.ages.append(time.monotonic() - self._heard_at)


def spec() -> TrialSpec:
    protocol = compose_protocol("utah2017_component", SHORT)
    person = Person(seed_text("live stick", "person"), seed_text("live stick", "trial"), 1)
    coupling = coupled(protocol, "full", protocol.routes[0], person)
    return replace(coupling, device=EmulatedStickDevice())


def in_this_process() -> dict[str, object]:
    """Drive one trial and measure it."""
    from stick import spread

    coupling, pace = spec(), Pace()
    with Timed(coupling.device) as stick:
        stick.open_trial(1)
        with before_others():
            result = run_trial(coupling, pace, stick)
        stick.close_trial()
        told = {measure.name: measure.value for measure in stick.measures(1)}
        with before_others():
            felt = _fields_to_motors(stick)
    figures: dict[str, object] = {
        "trial": f"{result.status} {result.reason}".strip(),
        "turns": told.get("device_turns", 0.0),
        "late_turns": told.get("late_turns", 0.0),
        "late_steps": pace.late,
        "late_fields": told["late_fields"],
        "frames_lost": told["dropped_frames"] + told["damaged_frames"],
    }
    if "turn_lateness_p50" in told:
        lateness = {name: told[f"turn_lateness_{name}"] for name in ("p50", "p99", "max")}
        figures["turn_lateness_ms"] = {
            name: round(value * 1e3, 2) for name, value in lateness.items()
        }
    if stick.ages:
        figures["stick_to_new_field_ms"] = spread(stick.ages)
    if felt:
        figures["fields_felt"] = len(felt)
        figures["new_field_to_motors_told_ms"] = spread(felt)
    return figures


def _fields_to_motors(stick: RemoteDevice) -> list[float]:
    """Order fields one after the other until the stick is in trouble, at most FIELDS."""
    stick.open_trial(2)
    _hold(stick, 1.0)
    felt: list[float] = []
    while len(felt) < FIELDS and not stick.trouble():
        felt.append(_order_to_motors(stick, len(felt)))
    return felt


def _order_to_motors(stick: RemoteDevice, index: int) -> float:
    """From ordering a field to the telemetry in which another force is told, s.

    Nothing pushed for a while, and the handle stands still.
    """
    push = 3.0 if index % 2 else -3.0
    _hold(stick, 0.1 + index * 1.37e-4)
    before, began = stick.report.values[0], time.monotonic()
    stick.render(ForceField(PlanarWrench(push, 0.0, 0.0), valid_for=0.02))
    stick.advance(GRIP)
    while abs(stick.report.values[0] - before) < FELT and not stick.trouble():
        time.sleep(5e-5)
    return time.monotonic() - began


def _hold(stick: RemoteDevice, seconds: float) -> None:
    """Hold the handle for a while, without force but never silent."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        stick.render(NO_FORCE)
        stick.advance(GRIP)
        time.sleep(0.01)


def live_figures() -> dict[str, dict[str, object]]:
    """Measure with and without real-time scheduling, and how soon it is drawn."""
    told = {}
    if real_time_means().scheduled:
        told["real-time scheduling"] = _apart(forbidden=False)
    told["ordinary scheduling"] = _apart(forbidden=True)
    told["page"] = page_lag()
    return told


def _apart(forbidden: bool) -> dict[str, object]:
    """Measure in a process of its own, which may be forbidden real-time scheduling."""
    ran = subprocess.run(
        [sys.executable, __file__],
        stdout=subprocess.PIPE, text=True, check=True,
        preexec_fn=_forbid if forbidden else None,
    )  # fmt: skip
    figures: dict[str, object] = json.loads(ran.stdout)
    return figures


def _forbid() -> None:
    resource.setrlimit(resource.RLIMIT_RTPRIO, (0, 0))
    ctypes.CDLL(None).prctl(PR_CAPBSET_DROP, CAP_SYS_NICE, 0, 0, 0)


def page_lag() -> dict[str, object]:
    """Run a trial live with a participant's page in headless Chromium; give what it stored."""
    import omnistudy
    from omnistudy.errors.view import NoBrowser
    from omnistudy.study import create_study
    from omnistudy.view.chromium import browser

    with TemporaryDirectory() as folder:
        study = Path(folder) / "lag.db"
        create_study(
            compose_protocol("utah2017_component", (*SHORT, "device=emulated_stick")), study, "lag"
        )
        try:
            with browser() as running:
                _driven_before(running, study)
        except NoBrowser as missing:
            return {"not_run": str(missing)}
        with omnistudy.open(study) as stored:
            events = stored.events(1)
        return {row.kind: row.detail for row in events.itertuples() if row.kind == "display"}


def _driven_before(running: object, study: Path) -> None:
    from omnistudy.view.chromium import Browser

    assert isinstance(running, Browser)
    command = "from omnistudy.cli.app import main; main()"
    verb = ("session", "run", str(study), "--trials", "1", "--live", "--no-open")
    with subprocess.Popen(
        [sys.executable, "-c", command, *verb], stderr=subprocess.PIPE, text=True
    ) as session:
        assert session.stderr is not None
        address = None
        while address is None:
            address = re.search(r"http://\S+", session.stderr.readline())
        running.tab(1280, 720).open(address[0])
        session.stderr.read()
        assert session.wait() == 0


if __name__ == "__main__":
    print(json.dumps(in_this_process()))

"""`omnistudy device check --force` and `familiarise`, with somebody at the emulated stick."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Iterator
from pathlib import Path
from queue import SimpleQueue

import pytest

from omnistudy.devices.stick.attendant import Attendant
from omnistudy.devices.stick.emulator import RELAXED_HAND, EmulatedStick
from omnistudy.devices.stick.pseudo_terminal import PseudoTerminal
from omnistudy.devices.stick.toolchain import missing_packages
from omnistudy.session.parts import part

OMNISTUDY = (sys.executable, "-c", "from omnistudy.cli.app import main; main()")


class Somebody:
    """At a stick whose board keeps pace with the wall clock in a thread, where all is done."""

    def __init__(self) -> None:
        self.board = EmulatedStick()
        self.attendant = Attendant(self.board)
        self.board.release()
        self.terminal = PseudoTerminal(self.board)
        self.told: SimpleQueue[str] = SimpleQueue()
        self.greatest_wanted = 255
        self.over = False
        self.thread = threading.Thread(target=self.terminal.keep_pace, args=(self.acts,))

    def acts(self) -> bool:
        """Do what was told, and let go when the stick pushes too much; True when all is over."""
        while not self.told.empty():
            sentence = self.told.get()
            if sentence.startswith("Hold the handle"):
                self.attendant.make_ready()
                for axis, grip in enumerate(RELAXED_HAND):
                    self.board.hold(axis, *grip)
            else:
                self.attendant(sentence)
        if max(self.board.duties) > self.greatest_wanted:
            self.board.hold_dead_man(False)
        return self.over

    def leave(self) -> None:
        self.over = True
        self.thread.join()
        self.terminal.close()
        self.board.close()


@pytest.fixture
def somebody() -> Iterator[Somebody]:
    missing = missing_packages()
    if missing:
        pytest.skip(f"needs {', '.join(missing)}: `make system-packages`")
    there = Somebody()
    there.thread.start()
    yield there
    there.leave()


def led(somebody: Somebody, lab: Path, *arguments: str) -> tuple[int, str, list[str]]:
    """Run the command while somebody does what it says; give exit code, output, sentences."""
    with subprocess.Popen(
        [*OMNISTUDY, "device", *arguments],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
        env={**os.environ, "OMNISTUDY_CONF": str(lab)},
    ) as ran:  # fmt: skip
        assert ran.stderr is not None
        assert ran.stdout is not None
        sentences = []
        for line in ran.stderr:
            sentences.append(line.strip())
            somebody.told.put(line.strip())
        printed = ran.stdout.read()
    return ran.returncode, printed, sentences


@pytest.mark.slow
def test_a_sound_stick_is_led_through_its_checks(somebody: Somebody, tmp_path: Path) -> None:
    code, printed, sentences = led(
        somebody, tmp_path, "check", somebody.terminal.path, "--force", "--json"
    )
    assert code == 0, printed
    findings = {one["what"]: one for one in json.loads(printed)}
    assert findings["emergency stop pressed"]["found"] == "noticed, and force went"
    assert findings["sign of theta"]["sound"]
    assert findings["rest of x"]["sound"]
    assert len(sentences) == 6


@pytest.mark.slow
def test_somebody_s_ceiling_becomes_a_page(somebody: Somebody, tmp_path: Path) -> None:
    somebody.greatest_wanted = 40
    code, printed, _ = led(
        somebody, tmp_path, "familiarise", somebody.terminal.path, "--page", "P01"
    )
    assert code == 0
    assert "wrote" in printed
    device = part("device", "P01", tmp_path)
    assert device.kind == "serial_stick"
    assert device.port == somebody.terminal.path
    # Forty of 255 steps are 2.1 N; of a push in x gravity takes a part, damping is felt as well.
    assert 1.0 <= device.ceiling.x <= 3.0
    assert 0.3 <= device.ceiling.theta <= 0.57


@pytest.mark.slow
def test_a_device_without_hardware_is_one_sentence(tmp_path: Path) -> None:
    for verb in (("check", "emulated_stick", "--force"),
                 ("familiarise", "emulated_stick", "--page", "P01")):  # fmt: skip
        ran = subprocess.run(
            [*OMNISTUDY, "device", *verb], capture_output=True, text=True, timeout=60
        )
        assert ran.returncode == 1
        assert ran.stderr.startswith("error: device 'emulated_stick' is no hardware")
        assert not (tmp_path / "device").exists()

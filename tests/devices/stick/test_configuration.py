"""Settings by message, and what EEPROM keeps of them."""

from __future__ import annotations

import pytest
from stick_bench import Bench

from omnistudy.devices.stick.layouts import DEFAULT_CONFIGURATION, LIMITS
from omnistudy.devices.stick.messages import Configuration, Fault
from omnistudy.errors.devices import Refused

STORED = 1 + 60 + 2
"""Bytes: version, settings, CRC."""


def restart(bench: Bench) -> None:
    bench.board.brown_out()
    bench.line.listen(0.02)


def faults(bench: Bench) -> Fault:
    return Fault(bench.line.listen(0.005)[-1].faults)


def test_a_new_board_uses_the_defaults_and_says_so(bench: Bench) -> None:
    assert bench.line.configuration() == DEFAULT_CONFIGURATION
    assert faults(bench) & Fault.DEFAULTS


def test_what_is_saved_survives_a_restart(bench: Bench) -> None:
    wanted = DEFAULT_CONFIGURATION._replace(serial=4711, travel=(290, 280, 1400))
    bench.line.configure(wanted)
    bench.line.save()
    assert not faults(bench) & Fault.DEFAULTS
    restart(bench)
    assert bench.line.configuration() == wanted
    assert bench.line.identify().serial == 4711
    assert faults(bench) == 0


def test_what_is_not_saved_does_not(bench: Bench) -> None:
    bench.line.configure(DEFAULT_CONFIGURATION._replace(serial=4711))
    restart(bench)
    assert bench.line.identify().serial == 0


@pytest.mark.parametrize("byte", [0, 1, 30, 60, 61, 62])
def test_a_damaged_eeprom_is_not_believed(bench: Bench, byte: int) -> None:
    bench.line.configure(DEFAULT_CONFIGURATION._replace(serial=4711))
    bench.line.save()
    stored = bytearray(bench.board.eeprom(0, STORED))
    stored[byte] ^= 0x10
    bench.board.write_eeprom(0, bytes(stored))
    restart(bench)
    assert bench.line.configuration() == DEFAULT_CONFIGURATION
    assert faults(bench) & Fault.DEFAULTS


@pytest.mark.parametrize("name", list(LIMITS[Configuration]))
def test_a_setting_outside_its_limits_is_refused_whole(bench: Bench, name: str) -> None:
    low, high = LIMITS[Configuration][name]
    value = getattr(DEFAULT_CONFIGURATION, name)
    refusable = {"counts_per_degree": low - 1, "slew_limit": 0, "rate_filter": 0}
    beyond = refusable.get(name, low - 1 if low > 0 else high + 1)
    wrong = (value[0], value[1], beyond) if isinstance(value, tuple) else beyond
    with pytest.raises(Refused, match="outside its limits"):
        bench.line.configure(DEFAULT_CONFIGURATION._replace(**{name: wrong}))
    assert bench.line.configuration() == DEFAULT_CONFIGURATION


def test_settings_do_not_change_while_there_is_force(bench: Bench) -> None:
    bench.bare()
    with pytest.raises(Refused, match="disarm first"):
        bench.line.configure(DEFAULT_CONFIGURATION)
    with pytest.raises(Refused, match="disarm first"):
        bench.line.save()
    with pytest.raises(Refused, match="disarm first"):
        bench.line.zero()
    bench.line.disarm()
    bench.line.configure(DEFAULT_CONFIGURATION)


def test_zero_makes_here_the_centre(bench: Bench) -> None:
    bench.board.turn(0, 120, 5_000)
    assert bench.line.listen(0.05)[-1].position == (120, 0, 0)
    bench.line.listen(0.1)
    bench.line.zero()
    heard = bench.line.listen(0.005)
    assert heard[-1].position == (0, 0, 0)
    # The stick did not move; the filter's rounding leaves two steps at most.
    assert max(abs(one.rate[0]) for one in heard) <= 2
    bench.board.turn(0, 0, 5_000)
    assert bench.line.listen(0.05)[-1].position == (-120, 0, 0)


def test_saving_stalls_no_tick(bench: Bench) -> None:
    bench.line.configure(DEFAULT_CONFIGURATION._replace(serial=0xA5A5A5A5))
    bench.line.save()
    assert bench.line.listen(0.005)[-1].missed == 0

"""The largest stable stiffness as a regression figure: benchmarks/stick_stiffness.py says how."""

from __future__ import annotations

import pytest
from stick_stiffness import HAND, LOOPS, NEWTONS_PER_METRE, STIFFEST, Hand, largest_stable

MOST = STIFFEST * NEWTONS_PER_METRE
"""N/m that a field can carry: there is no more to be had."""
BARE = {
    "board, spring": 1_947,
    "board, spring and damper": 13_031,
    "host, spring": 95,
    "host, spring, ramped": 84,
    "host, spring and damper": 564,
    "host, spring and damper, ramped": 488,
}
HELD = {
    "board, spring": MOST,
    "board, spring and damper": MOST,
    "host, spring": 1_004,
    "host, spring, ramped": 869,
    "host, spring and damper": 1_459,
    "host, spring and damper, ramped": 1_264,
}
"""N/m, as `python benchmarks/stick_stiffness.py` measured them."""


@pytest.mark.slow
@pytest.mark.usefixtures("toolchain")
@pytest.mark.parametrize(("hand", "known"), [(None, BARE), (HAND, HELD)], ids=["bare", "hand"])
def test_the_board_holds_ten_times_the_stiffness_of_a_host_loop(
    hand: Hand | None, known: dict[str, float]
) -> None:
    measured = {name: largest_stable(loop, hand) for name, loop in LOOPS.items()}
    assert measured == pytest.approx(known, rel=0.1)
    for damper in ("", " and damper"):
        board = measured[f"board, spring{damper}"]
        for ramp in ("", ", ramped"):
            assert board >= 10 * measured[f"host, spring{damper}{ramp}"]

"""Whatever comes over the line, nothing but a sound, legal, new field moves a motor."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from stick_bench import Bench, field

from omnistudy.devices.stick.frames import encode, frame_of
from omnistudy.devices.stick.layouts import CODES, DEFAULT_CONFIGURATION, LAYOUTS, LIMITS
from omnistudy.devices.stick.messages import (
    Arm,
    Field,
    Ping,
    SaveConfiguration,
    SetConfiguration,
    State,
    Zero,
)

PUSH = field(wrench=(200, -200, 200), stiffness=(2.0,) * 9)
BATCH = 100
Random = np.random.Generator
Forge = Callable[[Random, int], bytes]


def damaged(random: Random, sequence: int) -> bytes:
    """Give a good field with bits flipped; a zero among them ends it early."""
    frame = bytearray(encode(PUSH, sequence))
    for at in random.integers(0, len(frame) - 1, random.integers(1, 4)):
        frame[at] ^= int(random.integers(1, 256))
    return bytes(frame)


def cut_short(random: Random, sequence: int) -> bytes:
    """Give a good field that ends early."""
    frame = encode(PUSH, sequence)
    return frame[: random.integers(1, len(frame) - 1)] + b"\0"


def noise(random: Random, sequence: int) -> bytes:
    """Give any bytes."""
    return random.bytes(int(random.integers(1, 90))) + b"\0"


def repeated(random: Random, sequence: int) -> bytes:
    """Give the field that was in force once, or one that is older."""
    return encode(PUSH, OLD - int(random.integers(0, 100)))


def wrong_length(random: Random, sequence: int) -> bytes:
    """Give a message with a sound CRC and too few or too many bytes."""
    kind = [Field, Arm, SetConfiguration, Ping][random.integers(0, 4)]
    size = LAYOUTS[kind].size
    length = int(random.integers(0, 97))
    return frame_of(bytes((CODES[kind], sequence)) + random.bytes(length + (length == size)))


def unknown(random: Random, sequence: int) -> bytes:
    """Give a message with a sound CRC that the host has no business to send."""
    code = int(random.choice([0, *range(0x0B, 0x100)]))
    return frame_of(bytes((code, sequence)) + random.bytes(int(random.integers(0, 97))))


def illegal(random: Random, sequence: int) -> bytes:
    """Give a field with a sound CRC and one value just or far outside its limits."""
    values = PUSH._asdict()
    name = str(random.choice([n for n in values if n != "valid_for"]))
    low, high = LIMITS[Field][name]
    beyond = int(random.choice([low - 1, high + 1, -(2**15), 2**15 - 1]))
    where = int(random.integers(0, len(values[name])))
    values[name] = tuple(beyond if i == where else v for i, v in enumerate(values[name]))
    if random.random() < 0.2:
        values["valid_for"] = int(random.choice([0, 251, 65535]))
    return encode(Field(**values), sequence)


def out_of_place(random: Random, sequence: int) -> bytes:
    """Give a request that only a stick without force may obey, or `arm` without its key."""
    settings = DEFAULT_CONFIGURATION._replace(centring_stiffness=(16383,) * 3)
    requests = (SetConfiguration(*settings), SaveConfiguration(), Zero(), Arm(sequence))
    return encode(requests[random.integers(0, 4)], sequence)


FORGERIES: tuple[Forge, ...] = (
    damaged, cut_short, noise, repeated, wrong_length, unknown, illegal, out_of_place,
)  # fmt: skip
OLD = 90
"""Sequence number of the field that was in force; forgeries carry those that come after it."""


def assault(bench: Bench, forgeries: tuple[Forge, ...], frames: int, seed: int) -> None:
    """Arm, let one field come and fade, then send forgeries; no pin may move."""
    random = np.random.default_rng(seed)
    bench.bare(silence=1000)
    bench.board.turn(0, 50, 5_000)  # so that any stiffness would push
    bench.board.write(encode(PUSH, OLD))
    bench.line.listen(0.6)
    assert bench.board.greatest_duty() > 150
    bench.board.greatest_duty()
    for _ in range(frames // BATCH):
        sent = [
            forgeries[random.integers(0, len(forgeries))](random, OLD + int(random.integers(1, 99)))
            for _ in range(BATCH)
        ]
        bench.board.write(encode(Ping(), 0) + b"".join(sent) + b"\0")
        while bench.board.waiting:
            bench.board.run(0.005)
        heard = bench.line.listen(0.002)
        assert bench.board.greatest_duty() == 0
    assert heard[-1].state == State.FORCE
    assert heard[-1].field == OLD
    assert heard[-1].missed == 0
    bench.board.write(encode(PUSH, OLD + 100))
    bench.line.listen(0.1)
    assert bench.board.greatest_duty() > 10


@pytest.mark.parametrize("forge", FORGERIES, ids=lambda forge: forge.__name__)
def test_no_forgery_of_any_kind_moves_a_motor(bench: Bench, forge: Forge) -> None:
    assault(bench, (forge,), 300, seed=1)


@pytest.mark.slow
def test_a_hundred_thousand_forgeries_move_no_motor(bench: Bench) -> None:
    assault(bench, FORGERIES, 100_000, seed=2)


def test_every_forgery_is_counted(bench: Bench) -> None:
    bench.bare()
    before = bench.line.listen(0.01)[-1].refused
    random = np.random.default_rng(3)
    for index in range(20):
        bench.board.write((illegal, unknown, wrong_length)[index % 3](random, 1 + index))
        assert bench.line.listen(0.005)[-1].refused - before == index + 1

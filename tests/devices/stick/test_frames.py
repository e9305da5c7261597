"""Frames as bytes, and what becomes of damaged ones."""

from __future__ import annotations

from binascii import crc_hqx

from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices.stick.frames import (
    LONGEST_FRAME,
    Deframer,
    decode,
    encode,
    frame_of,
    stuff,
    unstuff,
)
from omnistudy.devices.stick.messages import Answer, Arm, Field, Hello, Ping

FIELD = Field((1, -2, 3), (4, 5, 6), (7, 0, 0, 0, 8, 0, 0, 0, 9), (0,) * 9, 100)


def test_the_crc_is_the_one_of_the_page() -> None:
    assert crc_hqx(b"123456789", 0xFFFF) == 0x29B1


def test_a_frame_as_bytes() -> None:
    # Ping has code 2; COBS of (02, 00, CRC): a run of one byte, the zero, the rest.
    crc = crc_hqx(b"\x02\x00", 0xFFFF).to_bytes(2, "big")
    assert encode(Ping(), 0) == b"\x02\x02\x03" + crc + b"\x00"


def test_what_is_encoded_is_decoded() -> None:
    for message in (Hello(), Arm(0x12345678), FIELD, Answer(1, 2, 3)):
        received = decode(encode(message, 200)[:-1])
        assert received is not None
        assert received.message == message
        assert type(received.message) is type(message)
        assert received.sequence == 200


@given(st.binary(max_size=253))
def test_stuffing_leaves_no_zero_and_loses_nothing(content: bytes) -> None:
    assert 0 not in stuff(content)
    assert unstuff(stuff(content)) == content


@given(st.integers(0, 8 * (len(encode(FIELD, 1)) - 1) - 1))
def test_a_flipped_bit_is_noticed(bit: int) -> None:
    frame = bytearray(encode(FIELD, 1))
    frame[bit // 8] ^= 1 << bit % 8
    assert Deframer().feed(b"\0" + bytes(frame)) == []


def test_the_stream_may_come_in_pieces_and_be_joined_midway() -> None:
    stream = encode(Ping(), 1)[2:] + encode(Ping(), 2) + encode(FIELD, 3)
    deframer = Deframer()
    received = [one for byte in stream for one in deframer.feed(bytes((byte,)))]
    assert [one.sequence for one in received] == [2, 3]
    assert deframer.damaged == 0


def test_unknown_short_and_long_frames_are_counted() -> None:
    deframer = Deframer()
    stream = b"\0" + frame_of(b"\x7f\0") + frame_of(b"\x05\0\1") + frame_of(b"\2\0\0") + b"\5\1\0"
    assert deframer.feed(stream) == []
    assert deframer.damaged == 4


def test_noise_without_an_end_is_not_kept() -> None:
    deframer = Deframer()
    for _ in range(100):
        deframer.feed(b"\1" * 100)
    assert len(deframer._rest) <= LONGEST_FRAME + 1

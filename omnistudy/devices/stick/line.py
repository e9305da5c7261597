"""One end of the serial line: requests and their answers, fields, telemetry."""

from __future__ import annotations

from collections import deque
from typing import TypeVar

from omnistudy.devices.stick.frames import Deframer, encode
from omnistudy.devices.stick.layouts import CODES, Message
from omnistudy.devices.stick.messages import (
    ARM_KEY,
    PROTOCOL_VERSION,
    Answer,
    Arm,
    ClearFaults,
    Configuration,
    Disarm,
    GetConfiguration,
    Hello,
    Identity,
    Outcome,
    SaveConfiguration,
    SetConfiguration,
    Telemetry,
    Zero,
)
from omnistudy.devices.stick.transport import Transport
from omnistudy.errors.devices import NoAnswer, Refused, WrongProtocol

ANSWER_WITHIN = 1.0
"""s; writing the EEPROM takes the longest: 60 bytes of 3.4 ms."""
ASKED = 4
"""Times that a question which changes nothing is asked within ANSWER_WITHIN (ours)."""

REASONS = {
    Outcome.UNKNOWN: "it does not know this message",
    Outcome.ILLEGAL: "a value is outside its limits",
    Outcome.NOT_NOW: "not while there is force or its memory is written; disarm first",
    Outcome.WRONG_KEY: "the key is wrong",
    Outcome.ESTOP: "the emergency stop is pressed or its wire is broken",
    Outcome.DEAD_MAN: "nobody holds the dead-man's switch",
    Outcome.FAULTY: "a fault is latched; clear the faults first",
    Outcome.MOVING: "the stick moves too fast or stands beyond its travel",
}

Kind = TypeVar("Kind", Answer, Identity, Configuration)


class StickLine:
    """Talks to one stick over any `Transport`."""

    def __init__(self, transport: Transport) -> None:
        self.transport = transport
        self.deframer = Deframer()
        self._telemetry: deque[Telemetry] = deque(maxlen=10_000)
        self._replies: deque[Message] = deque(maxlen=100)
        self._sequence = 0
        # What stands before the first zero byte is no frame to the device either.
        transport.write(b"\0")

    def send(self, message: Message) -> int:
        """Send without waiting; give the sequence number."""
        self._sequence = (self._sequence + 1) & 0xFF
        self.transport.write(encode(message, self._sequence))
        return self._sequence

    def listen(self, seconds: float) -> list[Telemetry]:
        """Let `seconds` of the line's time pass; give the telemetry since the last listening."""
        end = self.transport.now() + seconds
        while (left := end - self.transport.now()) > 1e-9:
            self._take(self.transport.read(left))
        heard = list(self._telemetry)
        self._telemetry.clear()
        return heard

    def drain(self) -> list[Telemetry]:
        """Take what has come without waiting; give the telemetry since the last listening."""
        self._take(self.transport.read(0.0))
        return self.listen(0.0)

    def met(self) -> list[Identity]:
        """Give what the stick has said of who it is since the last asking; forget other replies."""
        identities = [reply for reply in self._replies if isinstance(reply, Identity)]
        self._replies.clear()
        return identities

    def _take(self, chunk: bytes) -> None:
        for message, _ in self.deframer.feed(chunk):
            if isinstance(message, Telemetry):
                self._telemetry.append(message)
            else:
                self._replies.append(message)

    def identify(self) -> Identity:
        """Ask who is there; raises NoAnswer, WrongProtocol."""
        identity = self._ask(Hello(), Identity, "hello")
        if identity.version != PROTOCOL_VERSION:
            raise WrongProtocol(identity.version, PROTOCOL_VERSION)
        return identity

    def configuration(self) -> Configuration:
        """Ask for the settings in use; raises NoAnswer."""
        return self._ask(GetConfiguration(), Configuration, "get_configuration")

    def configure(self, configuration: Configuration) -> None:
        """Use settings until the next reset; raises Refused, NoAnswer."""
        self._request(SetConfiguration(*configuration), "set_configuration")

    def save(self) -> None:
        """Write the settings in use to the device's EEPROM; raises Refused, NoAnswer."""
        self._request(SaveConfiguration(), "save_configuration")

    def arm(self) -> None:
        """Begin the soft start; raises Refused, NoAnswer."""
        self._request(Arm(ARM_KEY), "arm")

    def disarm(self) -> None:
        """Turn the motors off; raises NoAnswer."""
        self._request(Disarm(), "disarm")

    def clear_faults(self) -> None:
        """Unlatch faults whose cause is gone; raises Refused, NoAnswer."""
        self._request(ClearFaults(), "clear_faults")

    def zero(self) -> None:
        """Tell the stick that it is in its centre; raises Refused, NoAnswer."""
        self._request(Zero(), "zero")

    def _ask(self, question: Message, kind: type[Kind], name: str) -> Kind:
        """Ask again while nothing comes: a device whose line is full does not reply."""
        for _ in range(ASKED):
            self.send(question)
            reply = self._reply(kind, ANSWER_WITHIN / ASKED)
            if reply is not None:
                return reply
        raise NoAnswer(name, ANSWER_WITHIN)

    def _request(self, message: Message, name: str) -> None:
        sequence = self.send(message)
        code = CODES[type(message)]
        while True:
            answer = self._reply(Answer, ANSWER_WITHIN)
            if answer is None:
                raise NoAnswer(name, ANSWER_WITHIN)
            if (answer.request, answer.sequence) == (code, sequence):
                break
        if answer.outcome != Outcome.DONE:
            raise Refused(name, REASONS[Outcome(answer.outcome)])

    def _reply(self, kind: type[Kind], seconds: float) -> Kind | None:
        """Give the next reply of a kind; None when none came within `seconds`."""
        end = self.transport.now() + seconds
        while True:
            while self._replies:
                reply = self._replies.popleft()
                if isinstance(reply, kind):
                    return reply
            left = end - self.transport.now()
            if left <= 1e-9:
                return None
            self._take(self.transport.read(left))

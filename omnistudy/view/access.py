"""Who may talk to the server: those with the token, on this machine's own pages."""

from __future__ import annotations

from dataclasses import dataclass
from http.cookies import SimpleCookie
from secrets import compare_digest
from urllib.parse import parse_qs, urlencode, urlsplit

LOOPBACK = ("127.0.0.1", "localhost", "::1")


@dataclass(frozen=True, slots=True)
class Asked:
    """What decides whether an answer is given; texts as they stand in the request."""

    host: str
    origin: str | None
    query: str
    cookie: str


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why there is no answer, for the person who reads it."""

    title: str
    text: str


FOREIGN = Refusal(
    "Another page asked for this",
    "Only pages of this server may talk to it. Open the address that the command printed, in a tab "
    "of its own.",
)
WRONG_TOKEN = Refusal(
    "The token is missing or wrong",
    "Open the address that the command printed, whole: it ends with ?token=... and every start of "
    "the command makes another one.",
)


@dataclass(frozen=True, slots=True)
class Access:
    """The token, and the host names by which the server may be called."""

    token: str
    hosts: tuple[str, ...] = LOOPBACK

    def refusal(self, asked: Asked) -> Refusal | None:
        """Give why a request is refused; None when it is not.

        A name that is none of ours is what a page gets at us by that makes its own name point here.
        """
        if urlsplit(f"//{asked.host}").hostname not in self.hosts:
            return FOREIGN
        if asked.origin is not None and urlsplit(asked.origin).netloc != asked.host:
            return FOREIGN
        if not self._right(self.brought(asked.query)) and not self._right(_kept(asked)):
            return WRONG_TOKEN
        return None

    def brought(self, query: str) -> str:
        """Give the token of an address, "" without one."""
        return parse_qs(query).get("token", [""])[0]

    def _right(self, given: str) -> bool:
        return compare_digest(given.encode(), self.token.encode())


def without_token(query: str) -> str:
    """Give the rest of an address's query."""
    return urlencode({name: v for name, v in parse_qs(query).items() if name != "token"}, True)


def cookie_name(host: str) -> str:
    """Give a name of this server's own: browsers keep one jar for all ports of a machine."""
    return f"omnistudy_{urlsplit(f'//{host}').port or 80}"


def _kept(asked: Asked) -> str:
    found = SimpleCookie(asked.cookie).get(cookie_name(asked.host))
    return found.value if found else ""

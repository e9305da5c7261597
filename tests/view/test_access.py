"""Who gets an answer."""

from __future__ import annotations

import pytest

from omnistudy.view.access import FOREIGN, WRONG_TOKEN, Access, Asked, Refusal, without_token

ACCESS = Access("secret")


@pytest.mark.parametrize(
    ("asked", "refusal"),
    [
        (Asked("127.0.0.1:8000", None, "token=secret", ""), None),
        (Asked("localhost:8000", None, "", "omnistudy_8000=secret"), None),
        (Asked("[::1]:8000", "http://[::1]:8000", "token=secret", ""), None),
        (Asked("127.0.0.1:8000", None, "", ""), WRONG_TOKEN),
        (Asked("127.0.0.1:8000", None, "token=Secret", ""), WRONG_TOKEN),
        (Asked("127.0.0.1:8000", None, "", "omnistudy_8001=secret"), WRONG_TOKEN),
        (Asked("127.0.0.1:8000", "http://evil.example", "token=secret", ""), FOREIGN),
        (Asked("127.0.0.1:8000", "http://127.0.0.1:9000", "token=secret", ""), FOREIGN),
        (Asked("127.0.0.1:8000", "null", "token=secret", ""), FOREIGN),
        (Asked("evil.example:8000", None, "token=secret", ""), FOREIGN),
        (Asked("", None, "token=secret", ""), FOREIGN),
    ],
)
def test_only_the_token_on_our_own_pages_is_answered(asked: Asked, refusal: Refusal | None) -> None:
    assert ACCESS.refusal(asked) == refusal


def test_the_token_leaves_the_address() -> None:
    assert without_token("token=secret&a=1") == "a=1"
    assert without_token("token=secret") == ""

"""Messages come and go as their events say."""

from __future__ import annotations

from omnistudy.channel import Event
from omnistudy.view.captions import Caption, Captions, captions

EVENTS = (
    Event(1.0, "start"),
    Event(2.0, "message", "Drive away from wall 1"),
    Event(3.0, "block", "red"),
    Event(3.0, "message", "Good Job"),
    Event(3.0, "message", "Move to Next Block"),
    Event(3.5, "message_closed", "Drive away from wall 1"),
    Event(7.0, "message_closed", "Good Job"),
    Event(9.0, "message", "Game Over - Next Round"),
)


def test_sentences_that_appear_together_leave_together() -> None:
    assert captions(EVENTS, 9.5) == (
        Caption(2.0, 3.5, ("Drive away from wall 1",)),
        Caption(3.0, 7.0, ("Good Job", "Move to Next Block")),
        Caption(9.0, 9.5, ("Game Over - Next Round",)),
    )


def test_what_is_on_the_screen_now_is_the_oldest_first() -> None:
    following = Captions()
    seen = []
    for event in EVENTS:
        following.take(event)
        seen.append(following.now)
    assert seen[0] == ()
    assert seen[4] == ("Drive away from wall 1", "Good Job", "Move to Next Block")
    assert seen[5] == ("Good Job", "Move to Next Block")
    assert seen[6] == ()

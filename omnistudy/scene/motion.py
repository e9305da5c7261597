"""Scripted paths of moving bodies: where a body is, and how fast it goes, at a time."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from itertools import pairwise
from math import dist, fmod, inf
from typing import Annotated, Literal, NamedTuple, Self

from pydantic import Field, model_validator

from omnistudy.registry.model import Model
from omnistudy.units import Metres, MetresPerSecond, Positive, Seconds

Place = tuple[Metres, Metres]


class Moment(NamedTuple):
    """Where a moving body is, m, and its velocity, m/s, in the world."""

    x: float
    y: float
    vx: float
    vy: float


class Patrol(Model):
    """From its own place past the waypoints at one speed, over and over; it does not turn."""

    kind: Literal["patrol"] = "patrol"
    waypoints: Annotated[tuple[Place, ...], Field(min_length=1)]
    """Where the body goes from its own place, one after the other, in the world."""
    speed: Annotated[MetresPerSecond, Positive]
    course: Literal["there_and_back", "round"] = "there_and_back"
    """The same way back, or straight from the last waypoint home."""
    pause: Annotated[Seconds, Field(ge=0)] = 0.0
    """Stay at either end; on a round at home alone."""
    offset: Annotated[Seconds, Field(ge=0)] = 0.0
    """How far into its course the body is when a trial opens."""

    def track(self, home: Place) -> Track:
        """Lay the path out in time for a body whose own place is `home`."""
        corners = [home, *self.waypoints]
        rounds = self.course == "round"
        corners += [home] if rounds else corners[-2::-1]
        turning = None if rounds else len(self.waypoints)
        times, places, t = [0.0], [home], 0.0
        for number, (start, end) in enumerate(pairwise(corners), start=1):
            t += dist(start, end) / self.speed
            times.append(t)
            places.append(end)
            if self.pause > 0.0 and number in (turning, len(corners) - 1):
                t += self.pause
                times.append(t)
                places.append(end)
        return Track(tuple(times), tuple(places), True, self.offset)


class Stop(NamedTuple):
    """A time in s after the trial opened, and where the body is then, m."""

    t: float
    x: float
    y: float


class Timetable(Model):
    """From its own place to each stop at its time, in straight lines; it does not turn."""

    kind: Literal["timetable"] = "timetable"
    stops: Annotated[tuple[tuple[Seconds, Metres, Metres], ...], Field(min_length=1)]
    """Rows of a time and the place that the body has reached by then."""
    repeats: bool = True
    """False: the body stays at its last stop."""

    @model_validator(mode="after")
    def _times_grow(self) -> Self:
        times = [0.0, *(row[0] for row in self.stops)]
        if any(later <= earlier for earlier, later in pairwise(times)):
            raise ValueError("the times of stops must grow, the first above 0 s")
        return self

    def track(self, home: Place) -> Track:
        """Lay the path out in time for a body whose own place is `home`."""
        stops = (Stop(0.0, *home), *(Stop(*row) for row in self.stops))
        times = tuple(stop.t for stop in stops)
        return Track(times, tuple((stop.x, stop.y) for stop in stops), self.repeats)


Motion = Annotated[Patrol | Timetable, Field(discriminator="kind")]


@dataclass(frozen=True, slots=True)
class Track:
    """A path in time: at `times[i]` (s, from 0, growing) the body is at `places[i]` (m).

    repeats : over and over; otherwise the body stays at its last place.
    offset : s that the body is ahead when a trial opens.
    """

    times: tuple[float, ...]
    places: tuple[Place, ...]
    repeats: bool
    offset: float = 0.0

    @property
    def period(self) -> float:
        """Duration in s after which everything is as before; infinite without repetition."""
        return self.times[-1] if self.repeats else inf

    @property
    def settled(self) -> float:
        """Time in s after which nothing new happens: one period, or the arrival for good."""
        return self.times[-1]

    @property
    def jumps(self) -> bool:
        """Whether the body would have to leap from the end of its path to the beginning."""
        return self.repeats and self.places[0] != self.places[-1]

    def at(self, t: float) -> Moment:
        """Give place and velocity at t seconds after the trial opened."""
        t += self.offset
        if self.repeats:
            t = fmod(t, self.times[-1])
        index = bisect_right(self.times, t)
        if index == len(self.times):
            return Moment(*self.places[-1], 0.0, 0.0)
        (ax, ay), (bx, by) = self.places[index - 1], self.places[index]
        duration = self.times[index] - self.times[index - 1]
        vx, vy = (bx - ax) / duration, (by - ay) / duration
        since = t - self.times[index - 1]
        return Moment(ax + vx * since, ay + vy * since, vx, vy)

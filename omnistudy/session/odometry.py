"""Where a robot was by its own account, and how far a simulated drive strays from that."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from omnistudy.errors.drive import NoCommonTime, NothingMapped
from omnistudy.geometry import PlanarPose, wrapped
from omnistudy.metrics import path_length
from omnistudy.operators.command_log import read_log


@dataclass(frozen=True, slots=True, eq=False)
class Odometry:
    """A robot's own account of a drive.

    times : (n,) s, strictly increasing, of the odometry's clock.
    poses : (n, 3) x, y in m and heading in rad without jumps at a half turn.
    """

    file: Path
    times: NDArray[np.float64]
    poses: NDArray[np.float64]

    def at(self, instant: float) -> PlanarPose:
        """Give the pose at an instant, between rows on a straight line, outside them at rest."""
        return PlanarPose(
            *(float(np.interp(instant, self.times, column)) for column in self.poses.T)
        )


@dataclass(frozen=True, slots=True)
class Comparison:
    """A simulated drive beside the odometry of the person who drove it.

    end_error_m : from where the simulated robot ends to where the odometry ends.
    end_error_share : the same as a share of the odometry's path length.
    heading_error_rad : simulated minus odometry's heading at the end, in [-pi, pi).
    largest_error_m, largest_error_at_s : the largest distance at equal stamps, and when, in s
        since the drive began.
    path_length_m, turned_rad : what the odometry drove and turned, left turns positive.
    """

    end_error_m: float
    end_error_share: float
    heading_error_rad: float
    largest_error_m: float
    largest_error_at_s: float
    path_length_m: float
    turned_rad: float


def read_odometry(
    file: Path, columns: Sequence[str | None] = ("time", "x", "y", "yaw")
) -> Odometry:
    """Read an odometry from CSV; columns are those of time, x, y and yaw.

    Raises NothingMapped when one is None, and what `read_log` raises.
    """
    time, *axes = columns
    if time is None or None in axes:
        raise NothingMapped("an odometry", "time, x, y and yaw", "--odometry-column")
    log = read_log(file, time, axes)
    poses = log.values.copy()
    poses[:, 2] = np.unwrap(poses[:, 2])
    return Odometry(file, log.times, poses)


def compare(
    odometry: Odometry, began: float, t: NDArray[np.float64], poses: NDArray[np.float64]
) -> Comparison:
    """Set a simulated drive beside an odometry, both seen from where they stood at the beginning.

    began : the stamp at which the simulated drive begins, s of the odometry's clock.
    t : (m,) s since then. poses : (m, 3) of the simulated robot; it rests where it ends, and the
        comparison goes on until the odometry ends.

    Raises NoCommonTime.
    """
    seen = float(odometry.times[0]), float(odometry.times[-1])
    ended = began + float(t[-1])
    if ended <= seen[0] or began >= seen[1]:
        raise NoCommonTime((began, ended), odometry.file, seen)
    later = odometry.times >= began
    stamps = np.concatenate(([began], odometry.times[later]))
    own = np.vstack([odometry.at(began), odometry.poses[later]])
    driven = np.column_stack([np.interp(stamps - began, t, column) for column in poses.T])
    own, driven = _from_the_start(own), _from_the_start(driven)
    errors = np.hypot(driven[:, 0] - own[:, 0], driven[:, 1] - own[:, 1])
    worst = int(errors.argmax())
    length = path_length(own[:, 0], own[:, 1])
    return Comparison(
        end_error_m=float(errors[-1]),
        end_error_share=float(errors[-1]) / length if length > 0.0 else np.inf,
        heading_error_rad=wrapped(float(driven[-1, 2] - own[-1, 2])),
        largest_error_m=float(errors[worst]),
        largest_error_at_s=float(stamps[worst] - began),
        path_length_m=length,
        turned_rad=float(own[-1, 2]),
    )


def _from_the_start(poses: NDArray[np.float64]) -> NDArray[np.float64]:
    """Express poses (n, 3) in the frame of the first."""
    start = PlanarPose(*poses[0].tolist())
    local = [(*start.to_local(x, y), theta - start.theta) for x, y, theta in poses.tolist()]
    return np.array(local)

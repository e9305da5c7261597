"""The first haptic stick of an omnidirectional wheelchair: nearness is stiffness."""

from __future__ import annotations

from math import sqrt
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from omnistudy.laws.boundary import Penetrations
from omnistudy.laws.impedance import ImpedanceLaw
from omnistudy.laws.law import Sensed


class ImpedanceUrbanoLaw(ImpedanceLaw):
    """The stick grows stiffer, whichever way it is held, the nearer the nearest obstacle is.

    tau = Jd·q'' + Dd·q' + Kd·q against the hand (Urbano et al. 2004 after Tyagi 2017, sec. 1.5,
    eq. 1.2-1.4). Jd is left out: a force field holds stiffness and damping, and a virtual inertia
    would need the stick's acceleration, which its encoders do not give without noise; the stick's
    own inertia stays. They varied Dd and Jd too, because the stick shook near obstacles, by values
    from simulations that are not given: here Dd grows with the root of Kd, so that the damping
    ratio of the virtual spring stays what it is at K0 (ours).
    """

    kind: Literal["impedance_urbano"] = "impedance_urbano"

    def counting(self, inside: Penetrations, sensed: Sensed) -> NDArray[np.bool_]:
        """Count every obstacle, on whichever side."""
        return np.ones(inside.rays.shape, np.bool_)

    def damped(self, stiffness: float) -> float:
        """Give D0·sqrt(K/K0), D0 where there is no stiffness."""
        return self.damping * sqrt(stiffness / self.stiffness) if self.stiffness else self.damping

"""The virtual driver: what it may know, and what must follow from that (docs/virtual-driver.md)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cache
from math import cos, nan, pi, sin, sqrt

import numpy as np
import pytest
from core_world import corner_world, trial

from omnistudy.controllers.rate import RateController
from omnistudy.devices import Hand, RunningDevice
from omnistudy.devices.simulated_stick import SimulatedStick
from omnistudy.geometry import ForceField, PlanarPose, PlanarTwist
from omnistudy.laws import Law
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.none import NoLaw
from omnistudy.laws.springs import Touches
from omnistudy.operators import Person
from omnistudy.operators.virtual_driver import Arm, VirtualDriver
from omnistudy.scene import Contacts, PlanarState
from omnistudy.trial import TrialResult, run_trial
from omnistudy.worlds import Leg, Situation, load_world

FX, FY, TAU = 10, 11, 12
SEEDS = ("0", "1", "2", "3")


class FlippedLaw(ComponentLaw):
    """The component law with the torque the wrong way round: it turns the robot into the wall."""

    def turning(self, touches: Touches, fx: float, fy: float) -> tuple[float, float]:
        torque, damping = super().turning(touches, fx, fy)
        return -torque, damping


def driver(skill: float = 2.6, stiffer: float = 1.0) -> VirtualDriver:
    """A driver like all others but for skill and an arm that is so many times as stiff."""
    return VirtualDriver(
        skill_median=skill,
        skill_spread=0.0,
        arm=Arm(
            stiffness_median=200.0 * stiffer,
            stiffness_spread=0.0,
            yaw_stiffness=2.0 * stiffer,
            yaw_damping=0.1 * sqrt(stiffer),
        ),
    )


@cache
def drives(law: type[Law], stiffer: float = 1.0, skill: float = 2.6) -> tuple[TrialResult, ...]:
    """The same people round the same corners, left and right."""
    return tuple(
        run_trial(
            trial(
                corner_world(mirrored=int(seed) % 2 == 1),
                seed=seed,
                law=law(kind=law.model_fields["kind"].default),
                operator=driver(skill, stiffer),
            )
        )
        for seed in SEEDS
    )


def collisions(results: tuple[TrialResult, ...]) -> int:
    return sum(result.collisions for result in results)


def paths_apart(first: TrialResult, second: TrialResult) -> float:
    rows = min(len(first.samples), len(second.samples))
    apart = first.samples[:rows, 1:3] - second.samples[:rows, 1:3]
    return float(np.hypot(*apart.T).max())


@pytest.mark.slow
def test_no_feedback_is_zero_force_bit_for_bit() -> None:
    for result in drives(NoLaw):
        forces = result.samples[:, FX : TAU + 1]
        assert forces.tobytes() == np.zeros_like(forces).tobytes()


def test_a_stick_that_renders_nothing_hides_the_law_from_the_driver() -> None:
    class DeafStick(SimulatedStick):
        """A stick whose cable is out: fields arrive, and nothing is felt."""

        def connect(self, physics_hz: int) -> RunningDevice:
            device = super().connect(physics_hz)
            device.render = lambda field: arrived.append(field)  # type: ignore[method-assign]
            return device

    arrived: list[ForceField] = []
    without, under_law = (
        run_trial(trial(law=law, device=DeafStick(), operator=driver()))
        for law in (NoLaw(), ComponentLaw())
    )
    assert any(field.wrench.fx for field in arrived)
    assert under_law.samples[:, FX].any()
    assert without.streams[0].data.tobytes() == under_law.streams[0].data.tobytes()
    assert without.samples[:, :FX].tobytes() == under_law.samples[:, :FX].tobytes()
    assert without.events == under_law.events


def test_feedback_helps_a_common_arm() -> None:
    assert collisions(drives(ComponentLaw)) < 0.5 * collisions(drives(NoLaw))


@pytest.mark.slow
def test_a_very_stiff_arm_takes_the_feedback_away() -> None:
    # nothing moves such an arm, so the drive is the one without feedback, collisions and all
    for felt, unfelt in zip(drives(ComponentLaw, 1e7), drives(NoLaw, 1e7), strict=True):
        assert paths_apart(felt, unfelt) < 0.02
        assert felt.collisions == unfelt.collisions
    common = zip(drives(ComponentLaw), drives(NoLaw), strict=True)
    assert min(paths_apart(felt, unfelt) for felt, unfelt in common) > 0.1


@pytest.mark.slow
def test_collisions_do_not_increase_as_the_arm_gets_softer() -> None:
    counted = [collisions(drives(ComponentLaw, stiffer)) for stiffer in (16.0, 4.0, 1.0, 0.25)]
    assert counted == sorted(counted, reverse=True)
    assert counted[-1] == 0
    assert counted[0] > 10


@pytest.mark.slow
def test_arm_stiffness_does_not_matter_without_feedback() -> None:
    soft, common, stiff = (collisions(drives(NoLaw, stiffer)) for stiffer in (0.25, 1.0, 1e7))
    assert 0.6 < soft / common < 1.6
    assert 0.6 < stiff / common < 1.6


@pytest.mark.slow
def test_flipped_torque_is_worse() -> None:
    right, flipped = drives(ComponentLaw), drives(FlippedLaw)
    assert collisions(flipped) > collisions(right)
    assert sum(r.duration_s for r in flipped) > 1.2 * sum(r.duration_s for r in right)


@pytest.mark.parametrize("law", [NoLaw, ComponentLaw])
def test_a_perfect_driver_never_collides(law: type[Law]) -> None:
    for result in drives(law, skill=0.0):
        assert (result.status, result.collisions, result.contact_time_s) == ("completed", 0, 0.0)


@pytest.mark.slow
@pytest.mark.slow
@pytest.mark.parametrize("route", ["red-green-blue", "red-blue-green", "blue-green-red"])
def test_a_perfect_driver_never_collides_in_the_published_world(route: str) -> None:
    world = load_world("utah2017")
    result = run_trial(trial(world, route=route, operator=driver(skill=0.0)))
    assert (result.status, result.collisions) == ("completed", 0)
    assert result.duration_s == pytest.approx(46.3 / 0.36, rel=0.2)


@pytest.mark.parametrize("law", [NoLaw(), ComponentLaw()], ids=["none", "component"])
def test_a_mirrored_map_is_driven_mirrored(law: Law) -> None:
    left, right = (
        run_trial(trial(corner_world(mirrored), law=law, operator=driver(skill=0.0)))
        for mirrored in (False, True)
    )
    assert left.duration_s == right.duration_s
    # t, x, y, theta, vx, vy, omega, stick x y theta, fx, fy, tau
    mirror = np.array([1, 1, -1, -1, 1, -1, -1, 1, -1, -1, 1, -1, -1])
    assert np.allclose(left.samples, right.samples * mirror, rtol=0, atol=1e-5)


def test_practice_makes_the_trial_number_worth_its_power_of_skill() -> None:
    # the 16th trial of somebody at 2.6 is like the first of somebody at 2.6 / 16^0.25 = 1.3
    sixteenth = run_trial(trial(operator=driver(2.6), person=Person("p", "t", 16)))
    better = run_trial(trial(operator=driver(1.3), person=Person("p", "t", 1)))
    assert sixteenth.samples.tobytes() == better.samples.tobytes()


def test_traits_are_drawn_once_a_person_from_the_stated_priors() -> None:
    virtual = VirtualDriver()
    people = [virtual.traits(f"participant {i}") for i in range(4000)]
    assert virtual.traits("participant 7") == people[7]
    skill = np.log([p.first_skill for p in people])
    arm = np.log([p.arm_stiffness for p in people])
    delay = np.array([p.delay for p in people])
    assert np.exp(np.median(skill)) == pytest.approx(2.6, rel=0.03)
    assert skill.std() == pytest.approx(0.3, rel=0.05)
    assert np.exp(np.median(arm)) == pytest.approx(200.0, rel=0.03)
    assert arm.std() == pytest.approx(0.35, rel=0.05)
    assert (delay.mean(), delay.std()) == pytest.approx((0.2, 0.03), rel=0.05)
    assert abs(np.corrcoef(skill, arm)[0, 1]) < 0.06


def test_a_quantile_gives_everybody_the_same_arm_and_leaves_the_rest_alone() -> None:
    drawn = VirtualDriver().traits("anybody")
    for quantile, stiffness in ((0.5, 200.0), (0.975, 200.0 * np.exp(0.35 * 1.959964))):
        traits = VirtualDriver(arm_stiffness_quantile=quantile).traits("anybody")
        assert traits.arm_stiffness == pytest.approx(stiffness)
        assert traits[:2] == drawn[:2]


def test_impedance_of_the_median_arm() -> None:
    virtual = VirtualDriver(arm_stiffness_quantile=0.5)
    arm = virtual.impedance(virtual.traits("anybody"))
    # zeta 0.7 on 0.9 kg: 1.4·sqrt(200·0.9) = 18.78 N·s/m (docs/virtual-driver.md)
    assert arm.stiffness == pytest.approx((200.0, 200.0, 2.0))
    assert arm.damping == pytest.approx((18.783, 18.783, 0.1), rel=1e-4)
    assert arm.mass == (0.8, 0.8, 0.003)


AHEAD = Leg(target="red", path=((0, 0), (5, 0)))
HZ = 240
FULL, FULL_TWIST = 0.04145 * (1 + 67 / 200), 1.0908 * (1 + 1.315 / 2.0)
"""References that hold a median arm's stick at its stop against the centring it knows."""

Sight = tuple[PlanarPose, Contacts, Situation]


def references(
    sights: Iterator[Sight] | list[Sight], skill: float = 0.0
) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
    """Where a median person pulls the stick to, step by step, while seeing this."""
    running = driver(skill).begin(Person("p", "t", 1), HZ)
    return np.array(
        [
            running.hand(i / HZ, PlanarState(pose, PlanarTwist(0, 0, 0), contacts), situation)
            .reference
            for i, (pose, contacts, situation) in enumerate(sights)
        ]
    )  # fmt: skip


def standing(pose: PlanarPose, seconds: float, leg: Leg | None = AHEAD) -> list[Sight]:
    return [(pose, Contacts(), Situation(leg))] * round(seconds * HZ)


def test_what_the_driver_has_learnt_of_the_stick_is_true_of_it() -> None:
    learnt, controller = VirtualDriver().stick, RateController()
    full = (learnt.full_travel, learnt.full_travel, learnt.full_twist)
    top = (learnt.top_speed, learnt.top_speed, learnt.top_turning)
    dead = (learnt.dead_zone, learnt.dead_zone, learnt.dead_zone_theta)
    assert controller.intent(full) == pytest.approx(top, rel=1e-3)
    for outside, moves in ((0.98, False), (1.05, True)):
        stick = tuple(outside * d * f for d, f in zip(dead, full, strict=True))
        assert [speed != 0.0 for speed in controller.intent(stick)] == [moves] * 3
    # a hand that pulls to its reference has the stick where it wants it, against the centring
    arm = driver().impedance(driver().traits("p"))
    device = SimulatedStick().connect(HZ)
    for _ in range(HZ):
        state = device.advance(Hand((0.5 * FULL, -0.5 * FULL, 0.5 * FULL_TWIST), *arm))
    half = (0.5 * full[0], -0.5 * full[1], 0.5 * full[2])
    assert state.position == pytest.approx(half, rel=0.01)


def test_what_is_seen_is_acted_on_a_delay_later() -> None:
    delay = driver().traits("p").delay
    pulled = references(standing(PlanarPose(0, 0, 0), 1.0))
    acted = int(np.argmax(pulled[:, 0] > 0)) / HZ
    assert delay <= acted <= delay + 1 / 20 + 1 / HZ
    assert pulled[-1] == pytest.approx((0.9 * FULL, 0.0, 0.0))


def test_off_the_way_the_stick_goes_back_to_it() -> None:
    # 0.15 m right of the way: 1.2·0.15/0.36 = half the stick to the left
    _, left, turn = references(standing(PlanarPose(1, -0.15, 0), 1.0))[-1]
    assert left == pytest.approx(0.5 * FULL)
    # and the point 0.7 m ahead lies to the left too: 1.6·atan(0.15/0.7)/1.2
    assert turn == pytest.approx(1.6 * np.arctan(0.15 / 0.7) / 1.2 * FULL_TWIST)


def test_small_wishes_step_over_the_dead_zone() -> None:
    # 1.2·0.05/0.36 = 0.17 of the stick would do nothing: 1.05 times 0.2222 does
    assert references(standing(PlanarPose(1, -0.05, 0), 1.0))[-1, 1] == pytest.approx(
        1.05 * 0.2222 * FULL
    )
    assert references(standing(PlanarPose(1, -0.02, 0), 1.0))[-1, 1] == 0.0


@pytest.mark.parametrize("heading", [pi / 2, -2.0, 3.0])
def test_what_lies_aside_is_turned_to_on_the_spot(heading: float) -> None:
    pulled = references(standing(PlanarPose(1, 0, heading), 1.0))[-1]
    assert pulled == pytest.approx((0.0, 0.0, -np.sign(heading) * FULL_TWIST))


def test_nowhere_to_go_is_a_still_hand() -> None:
    assert not references(standing(PlanarPose(1, 0.3, 1), 1.0, leg=None)).any()


def test_a_person_told_to_drive_away_does_so_for_a_while() -> None:
    # the wall is on the left and a little behind: away from it is right and a little ahead
    touching = Contacts(walls=("w",), clear=False, bearing=pi / 2 + 0.6)
    still = standing(PlanarPose(1, 0, 0), 1.0)
    warned: list[Sight] = [(PlanarPose(1, 0, 0), touching, Situation(AHEAD, True))] * (2 * HZ)
    pulled = references(still + warned)[HZ:]
    away = pulled[:, 1] != 0.0
    begins = int(np.argmax(away))
    lasts = int(np.argmin(away[begins:]))
    assert 0.4 <= begins / HZ <= 0.4 + 2 / 20
    assert 0.5 <= lasts / HZ <= 0.9 + 2 / 20
    share = 0.6 * FULL
    assert pulled[begins] == pytest.approx((share * sin(0.6), -share * cos(0.6), 0.0))


def test_a_touch_without_the_message_changes_nothing() -> None:
    touching = Contacts(walls=("w",), clear=False, bearing=0.5)
    silent: list[Sight] = [(PlanarPose(1, 0, 0), touching, Situation(AHEAD))] * HZ
    told_from_afar: list[Sight] = [
        (PlanarPose(1, 0, 0), Contacts(bearing=nan), Situation(AHEAD, True))
    ] * HZ
    plain = references(standing(PlanarPose(1, 0, 0), 1.0))
    assert np.array_equal(references(silent), plain)
    assert np.array_equal(references(told_from_afar), plain)


def test_a_robot_that_stays_where_it_is_is_pushed_harder_up_to_three_times() -> None:
    pulled = references(standing(PlanarPose(1, 0, 0), 8.0))[:, 0]
    first = pulled[HZ - 1]
    assert first == pytest.approx(0.9 * FULL)
    # from the second second on half as much again each second, to three times after five
    assert pulled[3 * HZ] == pytest.approx((1.0 + 0.5 * 2.0) * first, rel=0.06)
    assert pulled[-1] == pytest.approx(3.0 * first)


def test_at_a_wall_nobody_pushes_harder() -> None:
    warned: list[Sight] = [
        (PlanarPose(1, 0, 0), Contacts(clear=False, bearing=nan), Situation(AHEAD, True))
    ] * (5 * HZ)
    assert references(warned)[:, 0].max() == pytest.approx(0.9 * FULL)


@pytest.mark.slow
def test_insisting_never_acts_without_feedback() -> None:
    patient = driver()
    meek = patient.model_copy(
        update={"decision": patient.decision.model_copy(update={"greatest_effort": 1.0})}
    )
    for seed in SEEDS:
        one, other = (
            run_trial(trial(corner_world(), seed=seed, law=NoLaw(), operator=operator))
            for operator in (patient, meek)
        )
        assert one.samples.tobytes() == other.samples.tobytes()


def test_noise_grows_with_want_of_skill() -> None:
    spread = [
        references(standing(PlanarPose(1, 0, 0), 60.0), skill=skill)[HZ:, 1].std()
        for skill in (0.0, 0.5, 2.0)
    ]
    assert spread[0] < 1e-12
    assert spread[1] < spread[2]

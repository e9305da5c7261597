"""Kinds: which class a `kind:` in a YAML file stands for."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from importlib import import_module
from importlib.metadata import EntryPoint, entry_points
from typing import Any

from omnistudy.errors import BrokenKind, UnknownKind

BUILT_IN: Mapping[str, Mapping[str, str]] = {
    "laws": {
        "none": "omnistudy.laws.none:NoLaw",
        "component": "omnistudy.laws.component:ComponentLaw",
        "zero_torque": "omnistudy.laws.zero_torque:ZeroTorqueLaw",
        "spring_damper": "omnistudy.laws.spring_damper:SpringDamperLaw",
        "quadrant": "omnistudy.laws.quadrant:QuadrantLaw",
        "quadrant_smoothed": "omnistudy.laws.quadrant_smoothed:QuadrantSmoothedLaw",
        "infrared": "omnistudy.laws.infrared:InfraredLaw",
        "impedance_urbano": "omnistudy.laws.impedance_urbano:ImpedanceUrbanoLaw",
        "impedance_kondo": "omnistudy.laws.impedance_kondo:ImpedanceKondoLaw",
        "sector_sum": "omnistudy.laws.sector_sum:SectorSumLaw",
    },
    "controllers": {
        "rate": "omnistudy.controllers.rate:RateController",
        "direct": "omnistudy.controllers.direct:DirectController",
        "differential": "omnistudy.controllers.differential:DifferentialController",
        "sri_wln": "omnistudy.controllers.sri_wln:SriWln",
        "pi_wln": "omnistudy.controllers.pi_wln:PiWln",
        "sri_ene": "omnistudy.controllers.sri_ene:SriEne",
        "pi_ene": "omnistudy.controllers.pi_ene:PiEne",
        "dual_qp": "omnistudy.controllers.dual_qp:DualQp",
        "power_assist": "omnistudy.controllers.power_assist:PowerAssistController",
    },
    "plants": {
        "youbot": "omnistudy.plants.youbot:Youbot",
        "nexus": "omnistudy.plants.nexus:Nexus",
    },
    "devices": {
        "simulated_stick": "omnistudy.devices.simulated_stick:SimulatedStick",
        "direct": "omnistudy.devices.direct:DirectDevice",
        "emulated_stick": "omnistudy.devices.emulated_stick:EmulatedStickDevice",
        "sdl_stick": "omnistudy.devices.handheld.sdl_stick:SdlStick",
        "force_stick": "omnistudy.devices.handheld.force_stick:ForceStick",
        "space_mouse": "omnistudy.devices.handheld.space_mouse:SpaceMouse",
        "keyboard": "omnistudy.devices.handheld.keyboard:Keyboard",
        "serial_stick": "omnistudy.devices.serial_stick:SerialStickDevice",
    },
    "operators": {
        "virtual_driver": "omnistudy.operators.virtual_driver:VirtualDriver",
        "recorded": "omnistudy.operators.recorded:RecordedOperator",
        "person": "omnistudy.operators.real_person:RealPerson",
    },
    "tasks": {
        "route": "omnistudy.tasks.route:RouteTask",
        "free": "omnistudy.tasks.free:FreeTask",
    },
    "worlds": {"plan": "omnistudy.worlds.world:World"},
    "orders": {
        "published_blocks": "omnistudy.protocol.ordering.published_blocks:PublishedBlocks",
        "latin": "omnistudy.protocol.ordering.latin:Latin",
        "williams": "omnistudy.protocol.ordering.williams:Williams",
        "permuted_blocks": "omnistudy.protocol.ordering.permuted_blocks:PermutedBlocks",
        "staircase": "omnistudy.protocol.ordering.staircase:Staircase",
    },
}
"""Group -> kind -> "module:Class". Strings, so that asking for names imports nothing heavy."""


@cache
def _announced(group: str) -> dict[str, EntryPoint]:
    return {point.name: point for point in entry_points(group=f"omnistudy.{group}")}


def kinds(group: str) -> tuple[str, ...]:
    """Name every kind of a group ("laws", "plants"), ours and those of installed packages."""
    return tuple(sorted({*BUILT_IN.get(group, {}), *_announced(group)}))


def load_kind(group: str, kind: str) -> type[Any]:
    """Give the class behind a kind; raises UnknownKind, or BrokenKind when its package fails."""
    path = BUILT_IN.get(group, {}).get(kind)
    if path is not None:
        module, _, name = path.partition(":")
        return getattr(import_module(module), name)  # type: ignore[no-any-return]
    point = _announced(group).get(kind)
    if point is None:
        raise UnknownKind(group, kind, kinds(group))
    try:
        return point.load()  # type: ignore[no-any-return]
    except (ImportError, AttributeError) as cause:
        raise BrokenKind(group, kind, str(cause)) from cause

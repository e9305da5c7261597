"""`omnistudy protocol`: what is to be run, before anybody runs it."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

import typer

from omnistudy.cli.arguments import AsJson, ProtocolArgument, protocol_names
from omnistudy.cli.output import print_json, print_line, print_table

if TYPE_CHECKING:
    from omnistudy.protocol import Protocol
    from omnistudy.protocol.balance import Balance

app = typer.Typer(no_args_is_help=True, help="Protocols: what is to be run.")

PAGE_WIDTH = 100
"""Characters a line of a page holds."""

PARTICIPANTS_SHOWN = 4
"""How many participants' orders a page shows; the others follow the same rule."""


OverridesArgument = Annotated[
    list[str] | None,
    typer.Argument(
        metavar="[KEY=VALUE]...", help="Changes, such as law=zero_torque or participants.count=4."
    ),
]


@app.command("list")
def list_(json: AsJson = False) -> None:
    """List the protocols that can be given by name.

    Example: omnistudy protocol list
    """
    from omnistudy.protocol.compose import listed_protocols

    entries = listed_protocols()
    if json:
        print_json([entry._asdict() for entry in entries])
    else:
        print_table("Protocols", ("name", "title", "file"), entries)


@app.command()
def show(
    protocol: ProtocolArgument, changes: OverridesArgument = None, json: AsJson = False
) -> None:
    """Print a whole protocol as one page, every number resolved.

    Example: omnistudy protocol show utah2017_component
    """
    from omnistudy.protocol import freeze
    from omnistudy.protocol.compose import compose_protocol

    composed = compose_protocol(protocol, changes or ())
    if json:
        print_line(freeze(composed).canonical_json)
    else:
        print_page(composed)


@app.command()
def check(
    file: Annotated[str, typer.Argument(help="A YAML file, or a protocol's name.")],
    changes: OverridesArgument = None,
    json: AsJson = False,
) -> None:
    """Look for every fault of a protocol, and say when its design balances; exits 1 for a fault.

    Example: omnistudy protocol check protocols/utah2017_component.yaml
    """
    from omnistudy.errors.protocol import ProtocolFaults
    from omnistudy.protocol import plan
    from omnistudy.protocol.balance import balance
    from omnistudy.protocol.compose import compose_protocol

    try:
        composed = compose_protocol(file, changes or ())
    except ProtocolFaults as mistake:
        if not json:
            raise
        print_json({"file": mistake.where, "faults": mistake.faults})
        raise typer.Exit(1) from mistake
    found = balance(composed)
    if json:
        print_json({"file": file, "faults": [], "balance": found._asdict()})
        return
    print_line(
        f"{file}: no faults; {len(composed.conditions)} conditions, "
        f"{composed.participants.count} {composed.participants.kind} participants, "
        f"{len(plan(composed, 0))} trials each"
    )
    _print_balance(found)


@app.command()
def diff(
    old: Annotated[
        str, typer.Argument(help="A protocol's name or file.", autocompletion=protocol_names)
    ],
    new: Annotated[str, typer.Argument(help="Another one.", autocompletion=protocol_names)],
    json: AsJson = False,
) -> None:
    """Say what differs between two protocols, path by path, after all is resolved.

    Example: omnistudy protocol diff utah2017_component my_protocol.yaml
    """
    from omnistudy.protocol import freeze
    from omnistudy.protocol.compose import compose_protocol
    from omnistudy.protocol.diff import diff as differences

    texts = [freeze(compose_protocol(name)).canonical_json for name in (old, new)]
    found = differences(*texts)
    if json:
        print_json([difference._asdict() for difference in found])
    elif found:
        for difference in found:
            print_line(str(difference))
    else:
        print_line("no difference")


def _print_balance(balance: Balance) -> None:
    people = " and ".join(str(count) for count in balance.participants)
    each = " in each stratum" if len(balance.participants) > 1 else ""
    sizes = ", ".join(str(balance.multiple * times) for times in (1, 2, 3))
    print_line(f"balances at {sizes}, ... participants{each}")
    for loss in balance.losses:
        print_line(f"not even at {people}: {loss}")


def print_page(protocol: Protocol) -> None:
    """Print a whole protocol for people, every number resolved."""
    from textwrap import fill

    from omnistudy.protocol import freeze

    frozen = freeze(protocol)
    print_line(f"{protocol.title}\n")
    print_line(f"{fill(protocol.description, PAGE_WIDTH)}\n")
    print_line(f"name         {protocol.name}")
    print_line(f"design hash  {frozen.design_hash}")
    print_line(f"site hash    {frozen.site_hash}\n")
    _print_people(protocol)
    _print_conditions(protocol)
    _print_orders(protocol)
    _print_parts(protocol)


def _print_people(protocol: Protocol) -> None:
    from omnistudy.protocol.schedule import session_duration
    from omnistudy.protocol.summary import settings

    expected = session_duration(protocol)
    rows = [
        *settings(protocol.site),
        *settings(protocol.participants, "participants."),
        *settings(protocol.session, "session."),
        ("session.expected", f"{expected:.0f}", "s"),
    ]
    print_table("People and site", ("what", "value", "unit"), rows)


def _print_conditions(protocol: Protocol) -> None:
    from omnistudy.protocol.summary import changes

    factors = [factor.name for factor in protocol.factors]
    rows = []
    for condition in protocol.conditions:
        levels = {level.factor: level.level for level in condition.levels}
        differs = "\n".join(str(change) for change in changes(protocol, condition.name))
        own = [levels[factor] for factor in factors]
        rows.append((condition.name, condition.masked_label, *own, differs or None))
    between = {factor.name for factor in protocol.factors if factor.vary == "between"}
    named = [f"{name} (between)" if name in between else name for name in factors]
    columns = ("condition", "masked label", *named, "differs in")
    print_table("Conditions", columns, rows)


def _print_orders(protocol: Protocol) -> None:
    from omnistudy.protocol import StudyPlan

    plan = StudyPlan(protocol)
    shown = min(PARTICIPANTS_SHOWN, protocol.participants.count)
    visits = [visit.name for visit in protocol.course]
    rows = []
    for trials in zip(*(plan.trials(slot) for slot in range(shown)), strict=True):
        first = trials[0]
        cells = [f"{trial.condition or 'chosen by the order'}\n{trial.route}" for trial in trials]
        rows.append((first.position, visits[first.visit - 1], first.kind, *cells))
    columns = ("trial", "visit", "kind", *(f"participant {slot + 1}" for slot in range(shown)))
    print_table("Orders of the first participants", columns, rows)


def _print_parts(protocol: Protocol) -> None:
    from textwrap import fill

    from omnistudy.protocol.summary import parts_of, settings

    world = protocol.world
    routes = [(route.name, route.length, len(route.legs)) for route in world.routes]
    print_line(f"World {world.name}: {world.title}")
    print_table("Routes", ("route", "length in m", "legs"), routes)
    rows = []
    for name, part in parts_of(protocol):
        texts = [f"{one.name} {one.value} {one.unit}".rstrip() for one in settings(part)]
        rows.append((name, fill("; ".join(texts), PAGE_WIDTH - 25)))
    print_table("Every number", ("part", "settings"), rows)

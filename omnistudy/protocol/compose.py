"""From a protocol's page to the protocol: find, compose, complete, validate, check."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, NamedTuple

import yaml
from pydantic import TypeAdapter, ValidationError

from omnistudy.errors import nearest
from omnistudy.errors.protocol import ProtocolFaults, UnknownProtocol
from omnistudy.protocol.checks import cross_faults, session_faults
from omnistudy.protocol.completion import PARTS, Page, completed
from omnistudy.protocol.design_checks import factor_faults
from omnistudy.protocol.faults import explained
from omnistudy.protocol.protocol import Protocol
from omnistudy.registry.conf import conf_roots, protocol_roots

GROUPS = (*PARTS, "recording", "messages")
"""Keys whose pages stand in folders of the same name; `law=none` chooses one."""


def compose_protocol(
    name_or_file: str | Path, overrides: Sequence[str] = (), lab: Path | None = None
) -> Protocol:
    """Give the protocol of a YAML file, or of a name in the folders of protocols.

    overrides : `law=zero_torque`, `participants.count=4`.
    lab : folder whose pages come before ours; None asks OMNISTUDY_CONF.

    Raises UnknownProtocol, or ProtocolFaults with every fault that was found.
    """
    from omnistudy.protocol.page import composed

    page = find_protocol(name_or_file, lab)
    folders = (page.parent, *protocol_roots(lab), *conf_roots(lab))
    existing = tuple(dict.fromkeys(folder for folder in folders if folder.is_dir()))
    try:
        tree = composed(page.stem, existing, overrides, GROUPS)
    except ProtocolFaults as fault:
        raise ProtocolFaults(str(page), fault.faults) from fault
    return read_protocol(completed(tree, page_reader(str(page), existing)), str(page))


def page_reader(where: str, folders: Sequence[Path]) -> Page:
    """Give what reads a page by group and name, for a protocol's page `where`.

    It raises ProtocolFaults for a page that no folder has.
    """

    def read(group: str, name: str) -> Any:
        from omnistudy.protocol.page import composed

        names = sorted(
            {page.stem for folder in folders for page in (folder / group).glob("*.yaml")}
        )
        if name not in names:
            known = f"its pages are {', '.join(names)}{nearest(name, names)}"
            raise ProtocolFaults(
                where, [f"{group}: given '{name}', but there is no such page: {known}"]
            )
        return composed(f"{group}/{name}", tuple(folders), (), ())[group]

    return read


def find_protocol(name_or_file: str | Path, lab: Path | None = None) -> Path:
    """Give the page of a file's path or of a protocol's name; raises UnknownProtocol."""
    path = Path(name_or_file)
    if path.suffix == ".yaml" and path.is_file():
        return path.resolve()
    pages = protocol_pages(lab)
    if str(name_or_file) not in pages:
        raise UnknownProtocol(str(name_or_file), pages)
    return pages[str(name_or_file)]


def protocol_pages(lab: Path | None = None) -> dict[str, Path]:
    """Name every protocol that can be given by name, with its page; the lab's come first."""
    pages: dict[str, Path] = {}
    for folder in protocol_roots(lab):
        for page in sorted(folder.glob("*.yaml")):
            pages.setdefault(page.stem, page)
    return pages


class ProtocolEntry(NamedTuple):
    """One line of a list of protocols; the title is "" for a page that does not say it."""

    name: str
    title: str
    file: str


def listed_protocols(lab: Path | None = None) -> tuple[ProtocolEntry, ...]:
    """List the protocols that can be given by name, faulty ones too."""
    return tuple(
        ProtocolEntry(name, _title(page), str(page))
        for name, page in sorted(protocol_pages(lab).items())
    )


def _title(page: Path) -> str:
    try:
        tree = yaml.safe_load(page.read_text(encoding="utf-8"))
    except (yaml.YAMLError, UnicodeDecodeError):
        return "(not readable as YAML)"
    return str(tree.get("title", "")) if isinstance(tree, dict) else ""


def read_protocol(tree: Mapping[str, Any], where: str) -> Protocol:
    """Validate a complete tree; raises ProtocolFaults with every fault that was found."""
    try:
        protocol = Protocol.model_validate(dict(tree))
    except ValidationError as error:
        parts = _valid_parts(tree)
        faults = explained(error, Protocol, tree)
        faults += cross_faults(Protocol.model_construct(**parts), parts)
        raise ProtocolFaults(where, faults) from error
    faults = cross_faults(protocol, Protocol.model_fields) or (
        *factor_faults(protocol),
        *session_faults(protocol),
    )
    if faults:
        raise ProtocolFaults(where, faults)
    return protocol


def _valid_parts(tree: Mapping[str, Any]) -> dict[str, Any]:
    """Give the fields that are valid by themselves, so that faults between them are found too.

    Conditions that are faulty only in a part are kept without their parts.
    """
    parts: dict[str, Any] = {}
    for name, field in Protocol.model_fields.items():
        hint: Any = Annotated[field.annotation, field]
        adapter: TypeAdapter[Any] = TypeAdapter(hint)
        given = tree.get(name, field.get_default())
        for value in (given, _without_parts(given) if name == "conditions" else given):
            try:
                parts[name] = adapter.validate_python(value)
                break
            except ValidationError:
                continue
    return parts


def _without_parts(conditions: Any) -> Any:
    if not isinstance(conditions, list):
        return conditions
    return [
        {key: value for key, value in condition.items() if key not in PARTS}
        if isinstance(condition, Mapping)
        else condition
        for condition in conditions
    ]

"""A page of YAML and everything it names, composed by Hydra into one tree."""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from hydra import compose, initialize_config_dir
from hydra.core.global_hydra import GlobalHydra
from hydra.core.override_parser.overrides_parser import OverridesParser
from hydra.errors import CompactHydraException, MissingConfigException, OverrideParseException
from omegaconf import OmegaConf
from omegaconf.errors import InterpolationResolutionError, OmegaConfBaseException
from yaml import YAMLError
from yaml.error import MarkedYAMLError

from omnistudy.errors import nearest
from omnistudy.errors.protocol import ProtocolFaults
from omnistudy.protocol.search_path import searching


def composed(
    name: str, folders: tuple[Path, ...], overrides: Sequence[str], groups: Sequence[str]
) -> dict[str, Any]:
    """Compose the page `name` and resolve it; the first folder that has a page wins.

    overrides : `law=zero_torque` chooses another page of a group, `law.compliance_centre=0.1` sets
        a value, whether or not the page wrote it.
    groups : keys for which `key=value` chooses a page.

    Raises ProtocolFaults with one sentence.
    """
    try:
        return _composed(name, folders, [_set_or_add(text, groups) for text in overrides])
    except MissingConfigException as fault:
        raise ProtocolFaults(name, [_missing_page(fault)]) from fault
    except OverrideParseException as fault:
        raise ProtocolFaults(name, [_bad_override(fault)]) from fault
    except CompactHydraException as fault:
        cause = f": {_first_line(fault.__cause__)}" if fault.__cause__ else ""
        raise ProtocolFaults(name, [f"{_first_line(fault)}{cause}"]) from fault
    except InterpolationResolutionError as fault:
        raise ProtocolFaults(name, [f"{fault.full_key}: {_first_line(fault)}"]) from fault
    except OmegaConfBaseException as fault:
        raise ProtocolFaults(name, [_first_line(fault)]) from fault
    except YAMLError as fault:
        raise ProtocolFaults(name, [_not_yaml(fault)]) from fault
    except (OSError, UnicodeDecodeError) as fault:
        raise ProtocolFaults(name, [f"cannot be read as text: {_first_line(fault)}"]) from fault
    except UserWarning as fault:
        raise ProtocolFaults(
            name, ["defaults: the last line of the list must be '- _self_', so that the page wins"]
        ) from fault


def _composed(name: str, folders: tuple[Path, ...], overrides: list[str]) -> dict[str, Any]:
    GlobalHydra.instance().clear()
    with warnings.catch_warnings(), searching(folders):
        warnings.simplefilter("error", UserWarning)
        with initialize_config_dir(config_dir=str(folders[-1]), version_base="1.3"):
            page = compose(config_name=name, overrides=overrides)
    tree = OmegaConf.to_container(page, resolve=True, throw_on_missing=True)
    assert isinstance(tree, dict)
    return {str(key): value for key, value in tree.items()}


def _set_or_add(text: str, groups: Sequence[str]) -> str:
    """Hydra refuses to set what no page wrote; here defaults stand in the models, so it must."""
    (override,) = OverridesParser.create().parse_overrides([text])
    plain = not (override.is_add() or override.is_force_add() or override.is_delete())
    chooses = override.key_or_group in groups and isinstance(override.value(), str)
    return f"++{text}" if plain and not chooses else text


def _missing_page(fault: MissingConfigException) -> str:
    given = str(fault.missing_cfg_file or "")
    group, _, page = given.rpartition("/")
    allowed = sorted(fault.options or ())
    if not allowed:
        return f"defaults: there is no page '{given}', nor any other in '{group}'"
    return (
        f"defaults: '{group}' has no page '{page}': its pages are {', '.join(allowed)}"
        f"{nearest(page, allowed)}"
    )


def _bad_override(fault: OverrideParseException) -> str:
    return f"'{fault.override}' is no override: write key=value, such as law.compliance_centre=0.1"


def _not_yaml(fault: YAMLError) -> str:
    if isinstance(fault, MarkedYAMLError) and fault.problem_mark is not None:
        mark = fault.problem_mark
        return f"{mark.name}, line {mark.line + 1}: {fault.problem}"
    return _first_line(fault)


def _first_line(fault: BaseException) -> str:
    return " ".join(str(fault).strip().splitlines()[0].split())

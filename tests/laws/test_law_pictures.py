"""Pictures of laws: what must be legible in them, and where they cannot go."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import numpy as np
import pytest
from laws.straight_walls import scan_of

from omnistudy.errors.laws import NoForce
from omnistudy.errors.pictures import PictureNotWritten
from omnistudy.geometry import ForceField, PlanarWrench, Scan
from omnistudy.laws import Law, Sensed
from omnistudy.laws.boundary import AnyBoundary, CircularBoundary, RectangularBoundary
from omnistudy.laws.component import ComponentLaw
from omnistudy.laws.drawing import draw_field
from omnistudy.laws.impedance_urbano import ImpedanceUrbanoLaw
from omnistudy.laws.quadrant import QuadrantLaw
from omnistudy.laws.scene_drawing import draw_scene
from omnistudy.laws.standard_scenes import STANDARD_SCENES
from omnistudy.registry import kinds, load_kind


class Broken(Law):
    """A law that divides by nothing."""

    kind: Literal["broken"] = "broken"

    def field(self, sensed: Sensed) -> ForceField:
        return ForceField(PlanarWrench(float("nan"), 0.0, 0.0))


def words(picture: Path) -> list[str]:
    """Give what is written in an SVG; matplotlib leaves each text as a comment."""
    lines = picture.read_text(encoding="utf-8").splitlines()
    return [line.strip()[5:-4] for line in lines if line.strip().startswith("<!-- ")]


def test_a_scene_is_drawn_round_the_robot_however_far_the_sensor_sees(tmp_path: Path) -> None:
    far = scan_of([(1.0, 1.0, 0.65)], max_range=50.0)
    draw_scene([ComponentLaw()], far, tmp_path / "far.svg")
    written = words(tmp_path / "far.svg")
    assert "torque, clockwise" in written
    assert any("6 rays touch the boundary" in text for text in written)
    assert any("Fx -5.52 N, Fy -2.41 N, torque -3.97 N" in text for text in written)
    assert "0.6" in written
    assert not {"2", "4", "10", "20", "40"} & set(written)


def test_the_standard_scenes_are_named_and_the_scale_given(tmp_path: Path) -> None:
    draw_field([ComponentLaw()], tmp_path / "field.svg")
    written = words(tmp_path / "field.svg")
    assert {scene.title for scene in STANDARD_SCENES} <= set(written)
    assert "10 N" in written


@pytest.mark.slow
def test_several_laws_are_set_side_by_side(tmp_path: Path) -> None:
    laws = [ComponentLaw(), QuadrantLaw(), ImpedanceUrbanoLaw()]
    draw_field(laws, tmp_path / "field.svg")
    written = words(tmp_path / "field.svg")
    assert {"component", "quadrant", "impedance_urbano"} <= set(written)
    assert "stick held full ahead" in written
    assert written.count("in an L corner") == 1
    draw_scene(laws, scan_of([(1.0, 1.0, 0.65)]), tmp_path / "scene.svg")
    written = words(tmp_path / "scene.svg")
    assert any("torque -3.97 N" in text for text in written)
    assert any("torque -0.60 N" in text for text in written)


@pytest.mark.parametrize("boundary", [RectangularBoundary(), CircularBoundary()])
def test_rays_from_off_the_centre_are_drawn_from_where_they_start(
    tmp_path: Path, boundary: AnyBoundary
) -> None:
    scan = Scan(np.array([0.0]), np.array([0.2]), 0.6, np.array([[0.2, 0.1]]))
    draw_scene([ComponentLaw(boundary=boundary)], scan, tmp_path / "scene.svg")
    assert "inside the boundary" in words(tmp_path / "scene.svg")


@pytest.mark.slow
@pytest.mark.parametrize("kind", kinds("laws"))
def test_every_kind_is_drawn_over_every_boundary_that_it_takes(tmp_path: Path, kind: str) -> None:
    law = load_kind("laws", kind)
    laws = [law()]
    if "boundary" in law.model_fields:
        laws += [law(boundary=RectangularBoundary()), law(boundary=CircularBoundary(radius=0.45))]
    draw_scene(laws, scan_of([(1.0, 1.0, 0.55)]), tmp_path / "scene.svg")
    titles = [text for text in words(tmp_path / "scene.svg") if text.startswith(f"law '{kind}'")]
    assert len(titles) == len(laws)
    draw_field(laws[-1:], tmp_path / "field.svg")
    assert any(f"law '{kind}'" in text for text in words(tmp_path / "field.svg"))


def test_a_law_that_gives_no_number_is_not_drawn(tmp_path: Path) -> None:
    with pytest.raises(NoForce, match="'broken'"):
        draw_field([Broken()], tmp_path / "field.svg")
    with pytest.raises(NoForce, match="finite"):
        draw_scene([Broken()], scan_of([(1.0, 0.0, 0.4)]), tmp_path / "scene.png")
    assert list(tmp_path.iterdir()) == []


def test_a_folder_that_is_not_there_gets_a_sentence(tmp_path: Path) -> None:
    with pytest.raises(PictureNotWritten, match="No such file or directory"):
        draw_field([ComponentLaw()], tmp_path / "nowhere" / "field.svg")

"""Maps mean what nav2_map_server's documentation says; the cells are worked out by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml
from PIL import Image

from omnistudy.errors.worlds import BrokenMap
from omnistudy.worlds.map_server import read_map

PAGE: dict[str, Any] = {
    "image": "map.png",
    "resolution": 0.05,
    "origin": [0.0, 0.0, 0.0],
    "negate": 0,
    "occupied_thresh": 0.65,
    "free_thresh": 0.196,
}


def page(folder: Path, **changes: Any) -> Path:
    file = folder / "map.yaml"
    given = {name: value for name, value in (PAGE | changes).items() if value is not None}
    file.write_text(yaml.safe_dump(given), encoding="utf-8")
    return file


def saved(folder: Path, pixels: list[Any], mode: str = "L", name: str = "map.png") -> None:
    """Save one row of pixels."""
    image = Image.new(mode, (len(pixels), 1))
    image.putdata(pixels)
    image.save(folder / name)


def cells(file: Path) -> list[int]:
    (row,) = read_map(file).cells.tolist()
    return list(row)


# Occupancy is (255 - grey) / 255: 89 gives 0.651 (above 0.65), 90 gives 0.647; 205 gives 0.19608
# (not below 0.196: the grey of map_saver's unknown cells), 206 gives 0.19216.
GREYS = [0, 89, 90, 205, 206, 255]


def test_trinary_cells_are_occupied_unknown_or_free(tmp_path: Path) -> None:
    saved(tmp_path, GREYS)
    assert cells(page(tmp_path)) == [100, 100, -1, -1, 0, 0]
    assert cells(page(tmp_path, mode="trinary")) == [100, 100, -1, -1, 0, 0]


def test_negate_makes_white_occupied(tmp_path: Path) -> None:
    saved(tmp_path, [0, 49, 50, 165, 166, 255])
    # Occupancy is grey / 255: 49 gives 0.192, 50 gives 0.19608; 165 gives 0.647, 166 gives 0.651.
    assert cells(page(tmp_path, negate=1)) == [0, 0, -1, -1, 100, 100]
    assert cells(page(tmp_path, negate=True)) == [0, 0, -1, -1, 100, 100]


def test_a_cell_at_a_threshold_is_neither_free_nor_occupied(tmp_path: Path) -> None:
    saved(tmp_path, [50, 51, 153, 154])  # 51 is exactly 0.2, 153 exactly 0.6
    file = page(tmp_path, negate=1, free_thresh=0.2, occupied_thresh=0.6)
    assert cells(file) == [0, -1, -1, 100]


def test_scale_grades_what_is_between_the_thresholds(tmp_path: Path) -> None:
    saved(tmp_path, [0, 51, 127, 128, 204, 255])
    # With thresholds 0.2 and 0.8: 51 is 0.8 and full; 127 is 0.50196 -> 50.33; 128 is 0.49804 ->
    # 49.67; 204 is 0.2 and nothing.
    file = page(tmp_path, mode="scale", occupied_thresh=0.8, free_thresh=0.2)
    assert cells(file) == [100, 100, 50, 50, 0, 0]


def test_raw_cells_are_the_pixels_up_to_100(tmp_path: Path) -> None:
    saved(tmp_path, [0, 1, 99, 100, 101, 255])
    assert cells(page(tmp_path, mode="raw")) == [0, 1, 99, 100, -1, -1]


def test_colours_are_averaged(tmp_path: Path) -> None:
    # (255 + 0 + 0) / 3 = 85 is occupied; (255 + 255 + 0) / 3 = 170 is unknown.
    saved(tmp_path, [(255, 0, 0), (255, 255, 0), (250, 255, 245)], "RGB")
    assert cells(page(tmp_path)) == [100, -1, 0]


def test_trinary_averages_alpha_in_and_scale_takes_any_transparency_for_unknown(
    tmp_path: Path,
) -> None:
    # Trinary: opaque black is (0 + 0 + 0 + 255) / 4 = 63.75, occupied; transparent white is
    # (3 * 255) / 4 = 191.25, unknown; opaque 120 is (360 + 255) / 4 = 153.75, unknown.
    pixels = [(0, 0, 0, 255), (255, 255, 255, 0), (120, 120, 120, 255), (255, 255, 255, 255)]
    saved(tmp_path, pixels, "RGBA")
    assert cells(page(tmp_path)) == [100, -1, -1, 0]
    saved(tmp_path, [(0, 0, 0, 255), (0, 0, 0, 254), (255, 255, 255, 0)], "RGBA")
    assert cells(page(tmp_path, mode="scale")) == [100, -1, -1]
    saved(tmp_path, [(0, 255), (255, 0), (255, 255)], "LA")
    assert cells(page(tmp_path)) == [100, -1, 0]


def test_plain_and_binary_greymaps_are_read_alike(tmp_path: Path) -> None:
    (tmp_path / "plain.pgm").write_text("P2\n# drawn by hand\n3 2\n255\n0 205 255\n255 255 0\n")
    (tmp_path / "binary.pgm").write_bytes(b"P5\n3 2\n255\n" + bytes([0, 205, 255, 255, 255, 0]))
    for image in ("plain.pgm", "binary.pgm"):
        # The first row of the image is the highest of the map.
        read = read_map(page(tmp_path, image=image)).cells
        assert read.tolist() == [[0, 0, 100], [100, -1, 0]]


def test_greys_of_fewer_and_of_more_steps_are_scaled(tmp_path: Path) -> None:
    (tmp_path / "few.pgm").write_text("P2\n3 1\n4\n0 3 4\n")  # 3/4 white is 0.25 occupied
    assert cells(page(tmp_path, image="few.pgm")) == [100, -1, 0]
    (tmp_path / "many.pgm").write_text("P2\n3 1\n65535\n0 52428 65535\n")  # 0.2 occupied
    assert cells(page(tmp_path, image="many.pgm")) == [100, -1, 0]
    Image.fromarray(np.array([[0, 52428, 65535]], dtype=np.uint16)).save(tmp_path / "map.png")
    assert cells(page(tmp_path)) == [100, -1, 0]


def test_an_image_elsewhere_is_found(tmp_path: Path) -> None:
    (tmp_path / "images").mkdir()
    saved(tmp_path / "images", GREYS)
    assert cells(page(tmp_path, image="images/map.png"))[0] == 100
    assert cells(page(tmp_path, image=str(tmp_path / "images" / "map.png")))[0] == 100


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"image": None}, "it is no map: image missing"),
        ({"negate": None, "origin": None}, "it is no map: origin, negate missing"),
        ({"image": "gone.pgm"}, "there is no image"),
        ({"resolution": 0}, "resolution is 0, where metres a pixel are needed"),
        ({"resolution": -0.05}, "resolution is -0.05"),
        ({"resolution": "5 cm"}, "resolution is '5 cm', where a number is needed"),
        ({"resolution": float("nan")}, "resolution is nan, where a number is needed"),
        ({"free_thresh": 0.7}, "free_thresh is 0.7 and occupied_thresh 0.65, where"),
        ({"occupied_thresh": 65}, "free_thresh is 0.196 and occupied_thresh 65, where"),
        ({"origin": [0.0, 0.0]}, "origin is [0.0, 0.0], where [x, y, yaw]"),
        ({"origin": [0.0, 0.0, "north"]}, "where [x, y, yaw] in m and rad is needed"),
        ({"mode": "binary"}, "mode is 'binary', where trinary, scale, raw are allowed"),
        ({"negate": 2}, "negate is 2, where 0 or 1 is needed"),
    ],
)
def test_a_broken_page_is_told_in_a_sentence(
    tmp_path: Path, changes: dict[str, Any], said: str
) -> None:
    saved(tmp_path, GREYS)
    with pytest.raises(BrokenMap) as broken:
        read_map(page(tmp_path, **changes))
    assert said in str(broken.value)
    assert "\n" not in str(broken.value)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("- 1\n- 2\n", "a mapping with"),
        ("image: [", "cannot be read as YAML"),
        ("", "it is no map"),
    ],
)
def test_a_page_that_is_no_map_is_refused(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "map.yaml"
    file.write_text(text, encoding="utf-8")
    with pytest.raises(BrokenMap, match=said):
        read_map(file)
    with pytest.raises(BrokenMap, match="there is no such file"):
        read_map(tmp_path / "nothing.yaml")


@pytest.mark.parametrize(
    "content",
    [
        pytest.param(b"P5\n100 100\n255\n" + bytes(50), id="fewer pixels than its header says"),
        pytest.param(b"P2\n3 1\n255\n0 255\n", id="plain, fewer pixels"),
        pytest.param(b"P5\n0 10\n255\n", id="no columns"),
        pytest.param(b"just text", id="no image"),
        pytest.param(b"", id="empty"),
    ],
)
def test_an_image_that_cannot_be_read_is_refused(tmp_path: Path, content: bytes) -> None:
    (tmp_path / "map.pgm").write_bytes(content)
    with pytest.raises(BrokenMap, match=r"the image .*map\.pgm cannot be read"):
        read_map(page(tmp_path, image="map.pgm"))


@pytest.mark.parametrize("side", [6000, 10_000, 20_000])
def test_a_far_too_large_image_is_refused_before_it_is_read(tmp_path: Path, side: int) -> None:
    (tmp_path / "map.pgm").write_bytes(f"P5\n{side} {side}\n255\n".encode())
    with pytest.raises(BrokenMap, match="pixels"):
        read_map(page(tmp_path, image="map.pgm"))

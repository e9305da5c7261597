"""A plan shows all there is, and no name of it is cut off or written over another."""

from __future__ import annotations

from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from omnistudy.scene import Body, Box, Patrol
from omnistudy.worlds import Leg, Route, Start, World, load_world, world_names
from omnistudy.worlds.drawing import draw_plan, extent


@pytest.mark.parametrize("name", world_names())
def test_names_lie_within_the_picture_and_apart(name: str) -> None:
    figure = Figure(figsize=(6.0, 7.0))
    canvas = FigureCanvasAgg(figure)
    axes = figure.add_axes((0.02, 0.1, 0.96, 0.86))
    draw_plan(load_world(name), axes)
    canvas.draw()
    texts = [text.get_window_extent() for text in axes.texts]
    legend = axes.get_legend()
    assert legend is not None
    boxes = [*texts, legend.get_window_extent()]
    for box in boxes:
        assert box.x0 >= 0.0
        assert box.y0 >= 0.0
        assert box.x1 <= figure.bbox.x1
        assert box.y1 <= figure.bbox.y1
    assert not [pair for pair in combinations(boxes, 2) if pair[0].overlaps(pair[1])]


def test_plan_reaches_as_far_as_the_routes_do() -> None:
    finish = Body(name="finish", role="finish", geometry=Box(x=0.2, y=0.2, z=0.1), x=4, y=0, z=0.05)
    way = Leg(target="finish", path=((0, 0), (0, 3), (5, -2), (4, 0)))
    world = World(
        name="open",
        start=Start(x=0, y=0),
        bodies=(finish,),
        routes=(Route(name="round", legs=(way,)),),
    )
    low, high = extent(world)
    assert (low.tolist(), high.tolist()) == ([0.0, -2.0], [5.0, 3.0])


def moving_world() -> World:
    cart = Body(
        name="cart",
        role="wall",
        geometry=Box(x=0.4, y=0.2, z=1),
        x=2,
        y=-3,
        z=0.5,
        motion=Patrol(waypoints=((2, 3), (7, 3)), speed=0.5, offset=2.0),
    )
    finish = Body(name="finish", role="finish", geometry=Box(x=0.2, y=0.2, z=0.1), x=4, y=0, z=0.05)
    way = Leg(target="finish", path=((0, 0), (4, 0)))
    return World(
        name="open",
        start=Start(x=0, y=0),
        bodies=(cart, finish),
        routes=(Route(name="across", legs=(way,)),),
    )


def test_a_moving_body_is_drawn_with_its_path_where_it_is_at_the_start() -> None:
    axes = Figure().add_subplot()
    draw_plan(moving_world(), axes)
    low, high = extent(moving_world())
    assert (low.tolist(), high.tolist()) == ([0.0, -3.1], [7.0, 3.0])
    lines = [line.get_xydata().tolist() for line in axes.lines]
    assert [[2, -3], [2, 3], [7, 3], [2, 3], [2, -3]] in lines
    # 2 s ahead at 0.5 m/s it is 1 m further on.
    outlines = [patch.get_xy()[:4].tolist() for patch in axes.patches]
    assert [[2.2, -1.9], [1.8, -1.9], [1.8, -2.1], [2.2, -2.1]] in [
        [[round(number, 9) for number in corner] for corner in outline] for outline in outlines
    ]


def test_a_grid_names_round_coordinates() -> None:
    figure = Figure()
    bare, lined = figure.subplots(1, 2)
    draw_plan(moving_world(), bare)
    draw_plan(moving_world(), lined, grid=True)
    named = [text.get_text() for text in lined.texts]
    added = named[: len(named) - len(bare.texts)]
    # 7 m in eight parts are 0.875 m each; the next round step below is 0.5 m.
    assert added[:15] == [f"{half / 2:g}" for half in range(15)]
    assert added[15:] == [f"{half / 2:g}" for half in range(-6, 7)]


def test_a_world_without_a_route_is_drawn_without_a_legend() -> None:
    axes = Figure().add_subplot()
    draw_plan(moving_world().model_copy(update={"routes": ()}), axes)
    assert axes.get_legend() is None

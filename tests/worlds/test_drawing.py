"""A plan shows all there is, and no name of it is cut off or written over another."""

from __future__ import annotations

from itertools import combinations

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from omnistudy.scene import Body, Box
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

"""What the simulation and a device's process tell each other comes back as it was."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from omnistudy.devices import DeviceState, Hand, Health
from omnistudy.devices.orders import LONGEST_TROUBLE, Order, OrderLayout, Report, ReportLayout
from omnistudy.geometry import ForceField, PlanarWrench

number = st.floats(allow_nan=False)
three = st.tuples(number, number, number)
matrix = st.tuples(three, three, three)
wrenches = st.builds(PlanarWrench, number, number, number)
fields = st.builds(ForceField, wrenches, three, matrix, matrix, number)
hands = st.one_of(st.just(Hand((), (), (), ())), st.builds(Hand, three, three, three, three))


@given(st.builds(Order, st.integers(0, 2**60), number, st.integers(0, 2**60), fields, hands))
def test_an_order_comes_back(order: Order) -> None:
    layout = OrderLayout(3)
    assert layout.unpack(layout.pack(order)) == order


def test_a_report_comes_back() -> None:
    report = Report(
        turn=4000,
        time=12.5,
        trial=3,
        rows=3999,
        health=Health(4001, 2, 1, (0, 7)),
        state=DeviceState((0.01, -0.5), (0.2, 0.0)),
        values=(1.5, 0.0, 3.0),
        trouble="the stick at /dev/ttyACM0 was unplugged: plug it in again, ü",
    )
    layout = ReportLayout(axes=2, values=3)
    assert layout.unpack(layout.pack(report)) == report


def test_a_trouble_too_long_is_cut() -> None:
    nothing = DeviceState((0.0,), (0.0,))
    report = Report(1, 0.0, 0, 0, Health(0, 0, 0, (0,)), nothing, (), "ü" * LONGEST_TROUBLE)
    layout = ReportLayout(axes=1, values=0)
    assert layout.unpack(layout.pack(report)).trouble == "ü" * (LONGEST_TROUBLE // 2)

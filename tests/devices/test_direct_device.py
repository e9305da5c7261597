"""The device that is no device: what is logged is what is commanded."""

from omnistudy.devices import DeviceState, Hand
from omnistudy.devices.direct import DirectDevice
from omnistudy.geometry import ForceField, PlanarWrench


def test_the_reference_passes_through_whatever_is_rendered() -> None:
    device = DirectDevice().connect(240)
    device.render(ForceField(PlanarWrench(10.0, 0.0, 0.0)))
    hand = Hand((0.2, -0.1, 0.3), (0, 0, 0), (0, 0, 0), (0, 0, 0))
    assert device.advance(hand) == DeviceState((0.2, -0.1, 0.3), (0.0, 0.0, 0.0))
    assert [axis.unit for axis in device.axes] == ["m/s", "m/s", "rad/s"]

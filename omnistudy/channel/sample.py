"""The columns that every driving study has, in their order in the `sample` table."""

from omnistudy.channel.channel import Channel

SAMPLE_CHANNELS = (
    Channel("x", "m", "robot's position in the world"),
    Channel("y", "m", "robot's position in the world"),
    Channel("theta", "rad", "robot's heading, counter-clockwise, not wrapped"),
    Channel("vx", "m/s", "forward velocity in the robot's frame"),
    Channel("vy", "m/s", "leftward velocity in the robot's frame"),
    Channel("omega", "rad/s", "turning rate, counter-clockwise"),
    Channel("stick_x", "m", "stick's position, forward"),
    Channel("stick_y", "m", "stick's position, left"),
    Channel("stick_theta", "rad", "stick's twist, counter-clockwise"),
    Channel("fx", "N", "feedback force of the law at the hand, forward, unclipped"),
    Channel("fy", "N", "feedback force of the law at the hand, left, unclipped"),
    Channel("tau", "N·m", "feedback torque of the law at the hand, counter-clockwise, unclipped"),
)
SAMPLE_COLUMNS = ("t", *(channel.name for channel in SAMPLE_CHANNELS))
"""`t` is in simulated seconds since the trial opened; a plant without a quantity leaves NaN."""

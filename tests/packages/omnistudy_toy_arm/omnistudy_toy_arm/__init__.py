"""A seven-joint arm, the device that leads its hand, and the task to reach for something."""

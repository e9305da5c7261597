"""What is to be done: start, events, success, end."""

from omnistudy.tasks.messages import Messages, Screen
from omnistudy.tasks.task import Progress, RunningTask, Task

__all__ = ["Messages", "Progress", "RunningTask", "Screen", "Task"]

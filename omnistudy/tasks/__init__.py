"""What is to be done: start, events, success, end."""

from omnistudy.tasks.messages import Called, Messages, Screen
from omnistudy.tasks.pages import Pages
from omnistudy.tasks.task import Progress, RunningTask, Task

__all__ = ["Called", "Messages", "Pages", "Progress", "RunningTask", "Screen", "Task"]

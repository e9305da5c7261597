"""What is to be done: start, events, success, end."""

from omnistudy.tasks.task import Progress, RunningTask, Task

__all__ = ["Progress", "RunningTask", "Task"]

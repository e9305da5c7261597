"""Orders: in which sequence a participant meets the conditions, one file each."""

from omnistudy.protocol.ordering.order import Order

__all__ = ["Order"]

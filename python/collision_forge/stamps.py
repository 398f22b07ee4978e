"""Comparison of stamps: the suite rounds to microseconds, stamps in a bag may be finer."""
from genpy import Time

RESOLUTION = 1000  # ns


def is_same(one: Time, other: Time) -> bool:
    """Return True if two stamps, of the suite and of its source, belong to the same frame of agents."""
    return abs(one.to_nsec() - other.to_nsec()) <= RESOLUTION

"""Comparison of stamps: the suite rounds to microseconds, a bag may be finer."""
from genpy import Time

RESOLUTION = 1000  # ns


def is_same(one: Time, other: Time) -> bool:
    """Return whether two stamps denote the same frame of agents, to RESOLUTION."""
    return abs(one.to_nsec() - other.to_nsec()) <= RESOLUTION

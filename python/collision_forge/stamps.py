"""Stamps of the suite are to the microsecond, those of a bag may be finer."""
from genpy import Time

RESOLUTION = 1000  # ns


def is_same(one: Time, other: Time) -> bool:
    """Of one frame of agents, as the suite has it and as its source has it."""
    return abs(one.to_nsec() - other.to_nsec()) <= RESOLUTION

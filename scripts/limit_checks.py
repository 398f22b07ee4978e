"""Shared by the checks of both sets of limits; part of check_limits."""
import math

BACKWARDS = 1e-3  # m that a step may lead back, as in the package's own check
ROUNDING = 1e-6   # of any unit


class Worst:
    """The worst violation of each limit."""

    def __init__(self):
        self.found = {}

    def check(self, name, value, limit, time, tolerance=ROUNDING):
        """`value` may exceed `limit` by `tolerance`, for what the difference that it is from may be off."""
        excess = value - limit - tolerance
        if excess > 0.0 and excess > self.found.get(name, (0.0,))[0]:
            self.found[name] = (excess, value, limit, time)

    def violations(self):
        """Return (limit, value, allowed value, s from t0) of each violated limit."""
        return [(name, value, limit, time) for name, (_, value, limit, time) in sorted(self.found.items())]


def turn(start, end):
    return math.remainder(end - start, 2.0 * math.pi)

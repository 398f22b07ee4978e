"""Functions shared by the checks of both sets of limits; part of check_limits."""
import math

BACKWARDS = 1e-3  # m that a step may move backwards, as in the package's own check
ROUNDING = 1e-6   # in any unit


class Worst:
    """The worst violation of each limit."""

    def __init__(self):
        self.found = {}

    def check(self, name, value, limit, time, tolerance=ROUNDING):
        """Record `value` if it exceeds `limit` by more than `tolerance`, the error of the finite differences."""
        excess = value - limit - tolerance
        if excess > 0.0 and excess > self.found.get(name, (0.0,))[0]:
            self.found[name] = (excess, value, limit, time)

    def violations(self):
        """Return (name, value, limit, s from t0) of the worst violation of each violated limit."""
        return [(name, value, limit, time) for name, (_, value, limit, time) in sorted(self.found.items())]


def turn(start, end):
    return math.remainder(end - start, 2.0 * math.pi)

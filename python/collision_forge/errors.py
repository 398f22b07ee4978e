"""Status codes and exceptions."""
import enum
from typing import Sequence


class Code(enum.IntEnum):
    """Status codes of GenerateCollision.srv and TestPlanner.srv; explained in docs/rejections.md."""

    OK = 0
    UNKNOWN_TYPE = 1
    TTA_OUT_OF_RANGE = 2
    UNKNOWN_ATTACKER = 3
    ABSENT_ATTACKER = 4
    TOO_LITTLE_HISTORY = 5
    NO_CANDIDATE = 6
    NO_ATTACK_WITHIN_LIMITS = 7
    NO_SCENE = 8
    NO_RECORDING = 9
    BEYOND_RECORDING = 10
    INVALID_INPUT = 11
    NODE_UNAVAILABLE = 12
    LOW_CONFIDENCE = 13
    NOT_BELIEVABLE = 14
    ROAD_DOES_NOT_ALLOW = 15
    STALE_SCENE = 16
    INTERNAL_ERROR = 17
    UNKNOWN_PLANNER = 32
    BAD_PARAMETER = 33
    NO_SCENARIO = 34
    UNREADABLE = 35
    UNFIT = 36


class ForgeError(Exception):
    """Base class of all exceptions of this package."""


class Declined(ForgeError):
    """A service rejected the request: `code` is the status, `reason` has field and value."""

    def __init__(self, code: int, reason: str) -> None:
        self.code = Code(code)
        self.reason = reason
        super().__init__('{}: {}'.format(self.code.name, reason))


class NotReady(ForgeError):
    """A wait timed out; `missing` lists the missing parts."""

    def __init__(self, missing: Sequence[str], timeout: float) -> None:
        self.missing = list(missing)
        super().__init__('waited {:g} s in vain for {}'.format(timeout, '; '.join(missing)))


class Unavailable(ForgeError):
    """A node of the suite stopped during a call."""

"""A player of bags that publishes up to a given time and then pauses the clock."""
from pathlib import Path
from typing import Iterator, List, Optional, Union

from genpy import Duration, Time

from collision_forge.bag_publisher import BagPublisher
from collision_forge.errors import ForgeError
from collision_forge.stamps import is_same
from collision_forge.waiting import Inbox, wait_until

SHOWN_TO = 0.05  # s, rounding of the printed duration, which must be a valid time


class Player:
    """Publishes a bag's messages and `/clock` up to a given time; created by `forge.play()`.

    Instants are in s from the bag's first frame of agents, as `--now` of `forge inject`. When a call returns,
    everything up to the instant is published, nothing after it, and `encoded_scene` has come for the newest frame of
    agents.
    """

    def __init__(self, bag: Union[str, Path], scenes: Inbox, timeout: float) -> None:
        self._source = BagPublisher(bag)
        self._scenes = scenes
        self._timeout = timeout

    # Position.

    @property
    def path(self) -> Path:
        """Path of the bag."""
        return self._source.path

    @property
    def now(self) -> Optional[float]:
        """Time up to which all is published, s; None before the first message."""
        return self._source.instant

    @property
    def stamp(self) -> Optional[Time]:
        """Stamp of the newest published frame of agents."""
        shown = self._source.frames_until(self._source.now)
        return shown[-1][1] if shown else None

    def instant_of(self, stamp: Time) -> float:
        """Return the time of the frame of agents with `stamp`, s."""
        return self._source.instant_at(self._source.time_of_frame(stamp))

    @property
    def duration(self) -> float:
        """Time from the first to the last frame of agents, s."""
        return self._source.length

    @property
    def is_at_end(self) -> bool:
        """True if no frame of agents is left."""
        return self._source.now is not None and self._source.now >= self._source.frames[-1][0]

    # Playing.

    def until(self, instant: float) -> 'Player':
        """Play to `instant`, s; restart the bag if that is past. Raise ForgeError beyond the bag's end."""
        if instant > self.duration + SHOWN_TO:
            raise ForgeError('until({}): the last frame of agents of {} is at {:.1f} s'.format(
                instant, self.path.name, self.duration))
        return self._play(self._source.start + Duration.from_sec(instant))

    def step(self, frames: int = 1) -> 'Player':
        """Play the next `frames` frames of agents."""
        return self._play(self._source.time_of_next_frame(frames))

    def go_on(self, seconds: Optional[float] = None, rate: Optional[float] = None) -> 'Player':
        """Play some seconds of the bag; default: up to its last frame of agents.

        `rate`: multiple of real time; by default as fast as possible.
        """
        begin = self._source.now or self._source.start
        end = self._source.frames[-1][0] if seconds is None else begin + Duration.from_sec(seconds)
        return self._play(end, rate)

    def every(self, seconds: float) -> Iterator[float]:
        """Play through the bag and pause every so many seconds, first at the current time; yield the time, s."""
        instant = self.now or 0.0
        while instant <= self.duration:
            self.until(instant)
            yield instant
            instant += seconds

    def close(self) -> None:
        """End all publishing."""
        self._source.close()

    def _play(self, end: Time, rate: Optional[float] = None) -> 'Player':
        mark = self._scenes.mark()
        if self._source.now is None or end < self._source.now:
            self._restart()
        before = self._source.frames_until(self._source.now)
        self._source.publish_until(end, rate)
        frames = self._source.frames_until(end)
        if len(frames) > len(before):
            self._wait_for_scene(frames[-1][1], mark)
        return self

    def _restart(self) -> None:
        """Return to the first message and wait until all subscribers are connected."""
        self._source.advertise()
        wait_until(self._unconnected, self._timeout)
        self._source.begin()

    def _unconnected(self) -> List[str]:
        missing = self._source.unconnected()
        if not self._scenes.is_connected():
            missing.append('a connection to the publisher of ' + self._scenes.topic)
        return missing

    def _wait_for_scene(self, stamp: Time, mark: int) -> None:
        def missing() -> List[str]:
            if self._scenes.find(lambda scene: is_same(scene.header.stamp, stamp), mark):
                return []
            return ['{} of the frame of agents at {:.3f} s: has the bag /lane_map, and a transform map -> base_link '
                    'at that time?'.format(self._scenes.topic, stamp.to_sec())]
        wait_until(missing, self._timeout)

    def __repr__(self) -> str:
        where = 'not started' if self.now is None else 'at {:.1f} s'.format(self.now)
        return '<Player of {}: {} of {:.1f} s>'.format(self.path.name, where, self.duration)

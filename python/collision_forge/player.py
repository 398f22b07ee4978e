"""A player of bags that goes exactly as far as it is told to, and then lets time stand still."""
import itertools
import time
from pathlib import Path
from typing import Any, Iterator, List, Optional, Tuple, Union

import rosbag
import rospy
from genpy import Duration, Time
from rosgraph_msgs.msg import Clock

from collision_forge.errors import ForgeError
from collision_forge.waiting import Graph, Inbox, names, wait_until

AGENTS = '/agents'
CLOCK = '/clock'
CLOCK_LEAD = 0.5  # s of the wall clock from the first /clock to the first message: whoever keeps transforms drops those
                  # that come before it has seen time jump back


class Player:
    """Publishes a bag's messages and `/clock`, up to an instant; `forge.play()` makes one.

    Instants are in s from the bag's first frame of agents, as `--now` of `forge inject`. When a call returns,
    everything up to the instant is published, nothing after it, and `encoded_scene` has come for the newest frame of
    agents.
    """

    def __init__(self, bag: Union[str, Path], scenes: Inbox, timeout: float) -> None:
        self.path = Path(bag)
        self._scenes = scenes
        self._timeout = timeout
        self._check_alone()
        self._bag = rosbag.Bag(str(bag))
        self._frames: List[Tuple[Time, Time]] = [(time_of, message.header.stamp) for _, message, time_of in
                                                 self._bag.read_messages(AGENTS)]
        if not self._frames:
            self._bag.close()
            raise ForgeError('{} has no frame of {}'.format(bag, AGENTS))
        self._publishers = {CLOCK: rospy.Publisher(CLOCK, Clock, queue_size=0, tcp_nodelay=True)}
        self._groups: Iterator[Tuple[Time, List[Any]]] = iter(())
        self._next: Optional[Tuple[Time, List[Any]]] = None
        self._now: Optional[Time] = None

    @staticmethod
    def _check_alone() -> None:
        if not rospy.get_param('/use_sim_time', False):
            raise ForgeError('/use_sim_time is not true: the nodes would not heed the clock of a bag')
        others = Graph().publishers_of(CLOCK) - {rospy.get_name()}
        if others:
            raise ForgeError('{} publishes {} already'.format(names(others), CLOCK))

    # Where it is.

    @property
    def now(self) -> Optional[float]:
        """The instant up to which all is published; None before the first one."""
        return None if self._now is None else (self._now - self._start).to_sec()

    @property
    def stamp(self) -> Optional[Time]:
        """The stamp of the newest frame of agents that is published."""
        shown = self._frames_until(self._now) if self._now else []
        return shown[-1][1] if shown else None

    def instant_of(self, stamp: Time) -> float:
        """The instant of the frame of agents with a stamp."""
        time_of = next((time_of for time_of, of in self._frames if of == stamp), None)
        if time_of is None:
            raise ForgeError('{} has no frame of agents at {:.3f} s'.format(self.path, stamp.to_sec()))
        return (time_of - self._start).to_sec()

    @property
    def duration(self) -> float:
        """s from the first frame of agents to the last one."""
        return (self._frames[-1][0] - self._start).to_sec()

    @property
    def is_at_end(self) -> bool:
        """No frame of agents is left."""
        return self._now is not None and self._now >= self._frames[-1][0]

    @property
    def _start(self) -> Time:
        return self._frames[0][0]

    def _frames_until(self, end: Time) -> List[Tuple[Time, Time]]:
        return [frame for frame in self._frames if frame[0] <= end]

    # Going on.

    def until(self, instant: float) -> 'Player':
        """Goes on to an instant; starts the bag anew if that is past."""
        return self._play(self._start + Duration.from_sec(instant))

    def step(self, frames: int = 1) -> 'Player':
        """Goes on to the next frame of agents, or that many frames."""
        shown = len(self._frames_until(self._now)) if self._now else 0
        if shown + frames > len(self._frames):
            raise ForgeError('{} ends before {} more frames of agents'.format(self.path, frames))
        return self._play(self._frames[shown + frames - 1][0])

    def go_on(self, seconds: Optional[float] = None, rate: Optional[float] = None) -> 'Player':
        """Goes on for some seconds of the bag, to its last frame of agents by default.

        `rate`: so many times as fast as the clock on the wall; by default as fast as it can.
        """
        begin = self._now or self._start
        return self._play(self._frames[-1][0] if seconds is None else begin + Duration.from_sec(seconds), rate)

    def every(self, seconds: float) -> Iterator[float]:
        """Goes on through the bag, and pauses every so many seconds, now first; yields the instant."""
        instant = self.now or 0.0
        while instant <= self.duration:
            self.until(instant)
            yield instant
            instant += seconds

    def close(self) -> None:
        """Publishes nothing any more."""
        for publisher in self._publishers.values():
            publisher.unregister()
        self._bag.close()

    def _play(self, end: Time, rate: Optional[float] = None) -> 'Player':
        mark = self._scenes.mark()
        if self._now is None or end < self._now:
            self._restart()
        began, before = self._now, self._frames_until(self._now) if self._now else []
        wall = time.monotonic()
        while self._next is not None and self._next[0] <= end:
            stamp, messages = self._next
            if rate:
                time.sleep(max(0.0, wall + (stamp - (began or self._start)).to_sec() / rate - time.monotonic()))
            self._publish(stamp, messages)
            self._next = next(self._groups, None)
        self._publish(end, [])
        self._now = end
        frames = self._frames_until(end)
        if len(frames) > len(before):
            self._wait_for_scene(frames[-1][1], mark)
        return self

    def _restart(self) -> None:
        """Back to the first message, with everybody who hears the bag connected."""
        self._now = None
        self._groups = self._messages_by_time()
        self._next = next(self._groups)
        for topic, message in self._first_of_topics():
            if topic not in self._publishers:
                self._publishers[topic] = rospy.Publisher(topic, type(message), queue_size=0, tcp_nodelay=True,
                                                          latch=self._is_latched(topic))
        wait_until(self._unconnected, self._timeout)
        self._publish(self._next[0], [])
        time.sleep(CLOCK_LEAD)

    def _messages_by_time(self) -> Iterator[Tuple[Time, List[Any]]]:
        """The messages of an instant together, agents last: they need the transform of that instant."""
        entries = ((stamp, topic, message) for topic, message, stamp in self._bag.read_messages())
        for stamp, group in itertools.groupby(entries, key=lambda entry: entry[0]):
            yield stamp, sorted(((topic, message) for _, topic, message in group), key=lambda entry: entry[0] == AGENTS)

    def _first_of_topics(self) -> Iterator[Tuple[str, Any]]:
        for topic in self._bag.get_type_and_topic_info().topics:
            if topic != CLOCK:
                yield topic, next(self._bag.read_messages(topic))[1]

    def _is_latched(self, topic: str) -> bool:
        return any(connection.topic == topic and connection.header.get('latching') == b'1'
                   for connection in self._bag._get_connections())  # the library has no other way to ask

    def _unconnected(self) -> List[str]:
        """Who hears a topic of the bag, as the master says, and is not connected to the player yet."""
        graph = Graph()
        missing = []
        for topic, publisher in self._publishers.items():
            publisher.impl.check()
            late = graph.subscribers_of(topic) - {connection.endpoint_id for connection in publisher.impl.connections}
            if late:
                missing.append('a connection to {}, which hear(s) {}'.format(names(late), topic))
        if not graph.subscribers_of(AGENTS):
            missing.append('somebody who hears ' + AGENTS)
        if not self._scenes.is_connected():
            missing.append('a connection to the publisher of ' + self._scenes.topic)
        return missing

    def _publish(self, stamp: Time, messages: List[Any]) -> None:
        self._publishers[CLOCK].publish(Clock(stamp))
        for topic, message in messages:
            if topic != CLOCK:
                self._publishers[topic].publish(message)

    def _wait_for_scene(self, stamp: Time, mark: int) -> None:
        def missing() -> List[str]:
            if self._scenes.find(lambda scene: scene.header.stamp == stamp, mark):
                return []
            return ['{} of the frame of agents at {:.3f} s: has the bag /lane_map, and a transform map -> base_link '
                    'at that time?'.format(self._scenes.topic, stamp.to_sec())]
        wait_until(missing, self._timeout)

    def __repr__(self) -> str:
        where = 'not started' if self.now is None else 'at {:.1f} s'.format(self.now)
        return '<Player of {}: {} of {:.1f} s>'.format(self.path.name, where, self.duration)

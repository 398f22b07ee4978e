"""Publishes the messages of a bag and `/clock`."""
import itertools
import struct
import time
from pathlib import Path
from typing import Any, Iterator, List, Optional, Tuple, Union

import rosbag
import rospy
from genpy import DeserializationError, Time
from rosgraph_msgs.msg import Clock

from collision_forge.errors import ForgeError
from collision_forge.stamps import is_same
from collision_forge.waiting import Graph, names

AGENTS = '/agents'
CLOCK = '/clock'
GLOBAL = (CLOCK, '/tf', '/tf_static')  # topics that are the same in every namespace
MADE_BY_SUITE = ('/attack_markers', '/map_markers', '/tested_report')  # topics of a bag with an attack that the suite
                                                                       # also publishes, from its attack and lane map
CLOCK_LEAD = 0.5  # s of the wall clock from the first /clock to the first message: a transform buffer drops transforms
                  # that arrive before it has detected the jump back in time
UNREADABLE = (OSError, RuntimeError, ValueError, struct.error, rosbag.ROSBagException,
              DeserializationError)  # errors of the library for a damaged bag


def published(topic: str) -> str:
    """Return the published name of a bag's topic: relative, like the subscriptions of the suite."""
    return topic if topic in GLOBAL else topic.lstrip('/')


class BagPublisher:
    """Publishes a bag's messages in order; must be the only publisher of `/clock`.

    Instants are s from the bag's first frame of agents, like `--now` of `forge inject`; times are the times in the bag.
    Call `begin()` first, then `publish_until()` repeatedly.
    """

    def __init__(self, bag: Union[str, Path]) -> None:
        self.path = Path(bag)
        self.now: Optional[Time] = None  # everything up to this time is published; None: nothing
        self._check_alone()
        try:
            self._bag = rosbag.Bag(str(bag))
            self.frames: List[Tuple[Time, Time]] = [(time_of, message.header.stamp) for _, message, time_of in
                                                    self._bag.read_messages(AGENTS)]  # time and stamp
        except UNREADABLE as error:
            raise self._unreadable(error) from error
        if not self.frames:
            self._bag.close()
            raise ForgeError('{} has no frame of {}'.format(bag, AGENTS))
        self._publishers = {CLOCK: rospy.Publisher(CLOCK, Clock, queue_size=0, tcp_nodelay=True)}
        self._groups: Iterator[Tuple[Time, List[Any]]] = iter(())
        self._next: Optional[Tuple[Time, List[Any]]] = None

    @staticmethod
    def _check_alone() -> None:
        if not rospy.get_param('/use_sim_time', False):
            raise ForgeError('/use_sim_time is not true, so the nodes would ignore the clock of a bag: '
                             'set it before they start')
        others = Graph().publishers_of(CLOCK) - {rospy.get_name()}
        if others:
            raise ForgeError('{} publishes {} already'.format(names(others), CLOCK))

    # Position in the bag.

    @property
    def start(self) -> Time:
        """Return the time of the first frame of agents."""
        return self.frames[0][0]

    @property
    def length(self) -> float:
        """Return the time from the first to the last frame of agents, s."""
        return self.instant_at(self.frames[-1][0])

    @property
    def is_over(self) -> bool:
        """Return True if all messages are published."""
        return self.now is not None and self._next is None

    @property
    def instant(self) -> Optional[float]:
        """Return the instant up to which everything is published, s; None before the first message."""
        return None if self.now is None else self.instant_at(self.now)

    def instant_at(self, time_of: Time) -> float:
        """Return the instant of a time in the bag, s."""
        return (time_of - self.start).to_sec()

    def frames_until(self, end: Optional[Time]) -> List[Tuple[Time, Time]]:
        """Return (time, stamp) of the frames of agents up to `end`; no frames for None."""
        return [] if end is None else [frame for frame in self.frames if frame[0] <= end]

    def time_of_frame(self, stamp: Time) -> Time:
        """Return the bag time of the frame of agents with `stamp`; raise ForgeError if there is none."""
        time_of = next((time_of for time_of, recorded in self.frames if is_same(recorded, stamp)), None)
        if time_of is None:
            raise ForgeError('{} has no frame of agents at {:.3f} s'.format(self.path, stamp.to_sec()))
        return time_of

    def time_of_next_frame(self, count: int = 1) -> Time:
        """Return the bag time of the `count`-th next frame of agents; raise ForgeError if the bag ends before."""
        shown = len(self.frames_until(self.now))
        if shown + count > len(self.frames):
            raise ForgeError('{} ends before {} more frame(s) of agents'.format(self.path, count))
        return self.frames[shown + count - 1][0]

    # Publishing.

    def advertise(self) -> None:
        """Advertise the bag's topics, without the topics MADE_BY_SUITE that a running suite publishes itself."""
        graph = Graph()
        for topic, message in self._first_of_topics():
            if topic in MADE_BY_SUITE and graph.publishers_of(published(topic)) - {rospy.get_name()}:
                continue
            if topic not in self._publishers:
                self._publishers[topic] = rospy.Publisher(published(topic), type(message), queue_size=0,
                                                          tcp_nodelay=True, latch=self._is_latched(topic))

    def begin(self, at: Optional[Time] = None) -> None:
        """Go to the bag's first message, or to the first one at or after `at`, and publish its time on `/clock`."""
        self.now = None
        self._groups = self._messages_by_time(at)
        self._next = next(self._groups)
        self._publish(self._next[0], [])
        time.sleep(CLOCK_LEAD)

    def publish_until(self, end: Time, rate: Optional[float] = None) -> None:
        """Publish the remaining messages up to `end`, then `end` on `/clock`.

        `rate` is the speed relative to the wall clock; None: as fast as possible."""
        began, wall = self.now or self.start, time.monotonic()
        while self._next is not None and self._next[0] <= end:
            stamp, messages = self._next
            if rate:
                time.sleep(max(0.0, wall + (stamp - began).to_sec() / rate - time.monotonic()))
            self._publish(stamp, messages)
            self._next = next(self._groups, None)
        self._publish(end, [])
        self.now = end

    def close(self) -> None:
        """Unregister all publishers and close the bag."""
        for publisher in self._publishers.values():
            publisher.unregister()
        self._bag.close()

    def unconnected(self) -> List[str]:
        """Return descriptions of the missing connections to subscribers of the bag's topics."""
        graph = Graph()
        missing = []
        for topic, publisher in self._publishers.items():
            publisher.impl.check()
            connected = {connection.endpoint_id for connection in publisher.impl.connections}
            late = graph.subscribers_of(published(topic)) - connected
            if late:
                missing.append('a connection to {}, subscribed to {}'.format(names(late), topic))
        if not graph.subscribers_of(published(AGENTS)):
            missing.append('a subscriber of ' + rospy.resolve_name(published(AGENTS)))
        return missing

    def _messages_by_time(self, begin: Optional[Time]) -> Iterator[Tuple[Time, List[Any]]]:
        """Yield the messages of each time together, agents last, because they need the transform of that time."""
        entries = ((stamp, topic, message) for topic, message, stamp in self._bag.read_messages(start_time=begin))
        try:
            for stamp, group in itertools.groupby(entries, key=lambda entry: entry[0]):
                yield stamp, sorted(((topic, message) for _, topic, message in group),
                                    key=lambda entry: entry[0] == AGENTS)
        except UNREADABLE as error:  # the file has changed since it was opened
            raise self._unreadable(error) from error

    def _unreadable(self, error: Exception) -> ForgeError:
        return ForgeError('{} cannot be read: {}'.format(self.path, error))

    def _first_of_topics(self) -> Iterator[Tuple[str, Any]]:
        for topic in self._bag.get_type_and_topic_info().topics:
            if topic != CLOCK:
                yield topic, next(self._bag.read_messages(topic))[1]

    def _is_latched(self, topic: str) -> bool:
        return any(connection.topic == topic and connection.header.get('latching') == b'1'
                   for connection in self._bag._get_connections())  # rosbag has no public function for it

    def _publish(self, stamp: Time, messages: List[Any]) -> None:
        self._publishers[CLOCK].publish(Clock(stamp))
        for topic, message in messages:
            if topic != CLOCK and topic in self._publishers:
                self._publishers[topic].publish(message)

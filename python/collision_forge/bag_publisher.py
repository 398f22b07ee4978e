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
MADE_BY_SUITE = ('/attack_markers', '/map_markers', '/tested_report')  # in an attacked bag: the suite publishes these,
                                                                       # too, from the bag's attack and lane map
CLOCK_LEAD = 0.5  # s of the wall clock from the first /clock to the first message: tf2 buffers drop
                  # transforms that arrive before they have observed the jump of time
UNREADABLE = (OSError, RuntimeError, ValueError, struct.error, rosbag.ROSBagException,
              DeserializationError)  # what the library says of a damaged bag


def published(topic: str) -> str:
    """Return the published name of a bag's topic: relative, like the subscriptions of the suite."""
    return topic if topic in GLOBAL else topic.lstrip('/')


class BagPublisher:
    """Publishes a bag's messages in order; must be the only publisher of `/clock`.

    Instants are in s from the bag's first frame of agents, as `--now` of `forge inject`; times are the bag's.
    Call `begin()` first, then `publish_until()` repeatedly.
    """

    def __init__(self, bag: Union[str, Path]) -> None:
        self.path = Path(bag)
        self.now: Optional[Time] = None  # bag time up to which messages are published; None: none
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
            raise ForgeError('/use_sim_time is not true: the nodes would not heed the clock of a bag')
        others = Graph().publishers_of(CLOCK) - {rospy.get_name()}
        if others:
            raise ForgeError('{} publishes {} already'.format(names(others), CLOCK))

    # Position.

    @property
    def start(self) -> Time:
        """Time of the first frame of agents."""
        return self.frames[0][0]

    @property
    def length(self) -> float:
        """Time from the first to the last frame of agents, s."""
        return self.instant_at(self.frames[-1][0])

    @property
    def is_over(self) -> bool:
        """True if no message is left."""
        return self.now is not None and self._next is None

    @property
    def instant(self) -> Optional[float]:
        """Time up to which all is published, s; None before the first message."""
        return None if self.now is None else self.instant_at(self.now)

    def instant_at(self, of: Time) -> float:
        return (of - self.start).to_sec()

    def frames_until(self, end: Optional[Time]) -> List[Tuple[Time, Time]]:
        return [] if end is None else [frame for frame in self.frames if frame[0] <= end]

    def time_of_frame(self, stamp: Time) -> Time:
        """Return the bag time of the frame of agents with `stamp`."""
        time_of = next((time_of for time_of, of in self.frames if is_same(of, stamp)), None)
        if time_of is None:
            raise ForgeError('{} has no frame of agents at {:.3f} s'.format(self.path, stamp.to_sec()))
        return time_of

    def time_of_next_frame(self, count: int = 1) -> Time:
        """Return the bag time of the next frame of agents, or of a later one."""
        shown = len(self.frames_until(self.now))
        if shown + count > len(self.frames):
            raise ForgeError('{} ends before {} more frame(s) of agents'.format(self.path, count))
        return self.frames[shown + count - 1][0]

    # Publishing.

    def advertise(self) -> None:
        """Advertise the topics and wait for their subscribers; skip topics that a running suite publishes."""
        graph = Graph()
        for topic, message in self._first_of_topics():
            if topic in MADE_BY_SUITE and graph.publishers_of(published(topic)) - {rospy.get_name()}:
                continue
            if topic not in self._publishers:
                self._publishers[topic] = rospy.Publisher(published(topic), type(message), queue_size=0,
                                                          tcp_nodelay=True, latch=self._is_latched(topic))

    def begin(self, at: Optional[Time] = None) -> None:
        """Seek to the first message, or the first at or after a time, and publish its time on `/clock`."""
        self.now = None
        self._groups = self._messages_by_time(at)
        self._next = next(self._groups)
        self._publish(self._next[0], [])
        time.sleep(CLOCK_LEAD)

    def publish_until(self, end: Time, rate: Optional[float] = None) -> None:
        """Publishes what is left up to a time, and that time; `rate` times as fast as the clock on the wall, or as fast
        as it can."""
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
        """End all publishing."""
        for publisher in self._publishers.values():
            publisher.unregister()
        self._bag.close()

    def unconnected(self) -> List[str]:
        """Return the subscribers of the bag's topics that are not connected yet."""
        graph = Graph()
        missing = []
        for topic, publisher in self._publishers.items():
            publisher.impl.check()
            connected = {connection.endpoint_id for connection in publisher.impl.connections}
            late = graph.subscribers_of(published(topic)) - connected
            if late:
                missing.append('a connection to {}, which hear(s) {}'.format(names(late), topic))
        if not graph.subscribers_of(published(AGENTS)):
            missing.append('somebody who hears ' + rospy.resolve_name(published(AGENTS)))
        return missing

    def _messages_by_time(self, begin: Optional[Time]) -> Iterator[Tuple[Time, List[Any]]]:
        """Yield the messages grouped by time, agents last because they need the transform of that time."""
        entries = ((stamp, topic, message) for topic, message, stamp in self._bag.read_messages(start_time=begin))
        try:
            for stamp, group in itertools.groupby(entries, key=lambda entry: entry[0]):
                yield stamp, sorted(((topic, message) for _, topic, message in group),
                                    key=lambda entry: entry[0] == AGENTS)
        except UNREADABLE as error:  # the file changed after it was opened
            raise self._unreadable(error) from error

    def _unreadable(self, error: Exception) -> ForgeError:
        return ForgeError('{} cannot be read: {}'.format(self.path, error))

    def _first_of_topics(self) -> Iterator[Tuple[str, Any]]:
        for topic in self._bag.get_type_and_topic_info().topics:
            if topic != CLOCK:
                yield topic, next(self._bag.read_messages(topic))[1]

    def _is_latched(self, topic: str) -> bool:
        return any(connection.topic == topic and connection.header.get('latching') == b'1'
                   for connection in self._bag._get_connections())  # the library has no public accessor

    def _publish(self, stamp: Time, messages: List[Any]) -> None:
        self._publishers[CLOCK].publish(Clock(stamp))
        for topic, message in messages:
            if topic != CLOCK and topic in self._publishers:
                self._publishers[topic].publish(message)

"""Waiting for nodes and messages, by the wall clock: under `use_sim_time` the ROS clock may stand still."""
import http.client
import threading
import time
import xmlrpc.client
from typing import Any, Callable, List, Optional, Sequence, Set

import rosgraph
import rospy

from collision_forge.errors import ForgeError, NotReady

INTERVAL = 0.02       # s between two checks
MASTER_ANSWERS = 5.0  # s, time-out; a local master responds in milliseconds


def wait_until(missing: Callable[[], Sequence[str]], timeout: float) -> None:
    """Poll `missing()` until it is empty; raise NotReady with the missing parts after `timeout` s."""
    deadline = time.monotonic() + timeout
    while True:
        still_missing = missing()
        if not still_missing:
            return
        if rospy.is_shutdown():
            raise ForgeError('ROS is shutting down')
        if time.monotonic() > deadline:
            raise NotReady(still_missing, timeout)
        time.sleep(INTERVAL)


class Inbox:
    """Keeps the newest messages of a topic. `mark()` returns a position; later calls select messages after it."""

    KEPT = 1000  # messages

    def __init__(self, topic: str, message_class: Any) -> None:
        self.topic = topic
        self._lock = threading.Lock()
        self._messages: List[Any] = []
        self._dropped = 0
        self._subscriber = rospy.Subscriber(topic, message_class, self._receive, tcp_nodelay=True)

    def _receive(self, message: Any) -> None:
        with self._lock:
            self._messages.append(message)
            excess = max(0, len(self._messages) - self.KEPT)
            del self._messages[:excess]
            self._dropped += excess

    def mark(self) -> int:
        with self._lock:
            return self._dropped + len(self._messages)

    def since(self, mark: int) -> List[Any]:
        """Return the messages after `mark`, oldest first."""
        with self._lock:
            return self._messages[max(0, mark - self._dropped):]

    def newest(self) -> Optional[Any]:
        with self._lock:
            return self._messages[-1] if self._messages else None

    def find(self, condition: Callable[[Any], bool], mark: int = 0) -> Optional[Any]:
        """Return the newest message after `mark` that meets `condition`, or None."""
        return next((message for message in reversed(self.since(mark)) if condition(message)), None)

    def is_connected(self) -> bool:
        self._subscriber.impl.check()  # drops closed connections
        return self._subscriber.get_num_connections() > 0

    def close(self) -> None:
        self._subscriber.unregister()


class LimitedTransport(xmlrpc.client.Transport):
    """Transport for calls to the master with a timeout."""

    def make_connection(self, host: Any) -> http.client.HTTPConnection:
        connection = super().make_connection(host)
        connection.timeout = MASTER_ANSWERS
        return connection


class Graph:
    """Publishers, subscribers and services known to the master."""

    def __init__(self) -> None:
        uri = rosgraph.get_master_uri()
        try:
            master = xmlrpc.client.ServerProxy(uri, transport=LimitedTransport())
            _, _, entries = master.getSystemState(rospy.get_name())
        except (OSError, ValueError, http.client.HTTPException, xmlrpc.client.Error) as error:
            # `from None`: the inner stack does not help the caller.
            raise ForgeError('no ROS master answers at ROS_MASTER_URI = {} ({}): start one, for example with '
                             'roslaunch collision_forge replay.launch bag:=BAG'.format(uri, error)) from None
        self.publishers, self.subscribers, self.services = (
            {name: set(nodes) for name, nodes in kind} for kind in entries)

    def publishers_of(self, topic: str) -> Set[str]:
        return self.publishers.get(rospy.resolve_name(topic), set())

    def subscribers_of(self, topic: str) -> Set[str]:
        return self.subscribers.get(rospy.resolve_name(topic), set())

    def has_service(self, name: str) -> bool:
        return rospy.resolve_name(name) in self.services


def names(nodes: Any) -> str:
    return ', '.join(sorted(nodes))

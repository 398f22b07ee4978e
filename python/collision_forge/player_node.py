"""The node `player`: plays a bag in real time; services pause, step and move it."""
import threading
import time
from typing import Any, Callable, List, Optional

import rospy
from genpy import Duration, Time
from std_msgs.msg import Bool, Float64
from std_srvs.srv import SetBool, SetBoolResponse, Trigger, TriggerResponse

from collision_forge import msg, srv
from collision_forge.bag_publisher import MADE_BY_SUITE, BagPublisher, published
from collision_forge.client import PUBLISHED
from collision_forge.errors import ForgeError, NotReady
from collision_forge.node import run_node
from collision_forge.waiting import Graph, wait_until

TICK = 0.02           # s of the wall clock from one /clock to the next
TICKS_PER_POSITION = 5  # ticks from one ~position to the next
HISTORY = 4.0         # s that are published again before the target of a jump back: the history of a request
SCENE_TIMEOUT = 10.0  # s of the wall clock for the suite to encode the frame after a jump back
SUITE_TIMEOUT = 60.0  # s of the wall clock for the suite to start


class PlayerNode:
    """Plays a bag with speed `rate` relative to the wall clock. At the end, pauses, or starts again if `loop` is set.

    Playing begins at `start`, s from the first frame of agents; earlier messages are published immediately."""

    def __init__(self, source: BagPublisher, start: float, rate: float, loop: bool, is_paused: bool) -> None:
        self._source = source
        self._start = start
        self._rate = rate
        self._loop = loop
        self._is_paused = is_paused
        self._lock = threading.Lock()  # guards the publisher and the state of the player
        self._ticked = 0.0             # s of the wall clock, last tick
        self._ticks = 0
        self._attack = msg.Attack()
        self._encoded: Optional[Time] = None  # stamp of the newest encoded scene
        self._paused = rospy.Publisher('~paused', Bool, queue_size=1, latch=True)
        self._position = rospy.Publisher('~position', Float64, queue_size=1)
        self._length = rospy.Publisher('~length', Float64, queue_size=1, latch=True)
        rospy.Subscriber('attack', msg.Attack, self._receive_attack)
        self._scenes = rospy.Subscriber('encoded_scene', msg.EncodedScene, self._receive_scene)

    def run(self) -> None:
        """Play until the node is shut down. If paused at the start, the frame of agents at `start` is published."""
        with self._lock:
            rospy.Service('~pause', SetBool, self._pause)
            rospy.Service('~step', Trigger, lambda _: self._answer(self._step))
            rospy.Service('~back_to_now', Trigger, lambda _: self._answer(self._go_back_to_now))
            rospy.Service('~seek', srv.Seek, self._answer_seek)
            self._length.publish(self._source.length)
            self._go_to(self._source.start + Duration.from_sec(self._start))
            self._set_paused(self._is_paused)  # published last: subscribers may call the services now
            if self._is_paused:
                rospy.loginfo('%s of %.1f s: request a collision, then continue with the button Play in RViz or with '
                              'rosservice call /player/pause false', self._state(), self._source.length)
        while not rospy.is_shutdown():
            with self._lock:
                self._tick()
            time.sleep(max(0.0, self._ticked + TICK - time.monotonic()))

    def _tick(self) -> None:
        """Publish messages up to the elapsed wall time. In a pause, publish /clock only, for nodes that start then."""
        before, self._ticked = self._ticked, time.monotonic()
        if self._ticks % TICKS_PER_POSITION == 0:
            self._position.publish(self._source.instant)
        self._ticks += 1
        if self._is_paused:
            self._source.publish_until(self._source.now)
            return
        if self._source.is_over:
            self._end()
            return
        self._source.publish_until(self._source.now + Duration.from_sec(self._rate * (self._ticked - before)))

    def _end(self) -> None:
        if self._loop:
            self._go_to(self._source.start)
        else:
            self._set_paused(True)

    def _go_to(self, end: Time, begin: Optional[Time] = None) -> None:
        """Restart the bag at `begin` (None: at its first message) and publish everything up to `end` immediately."""
        self._source.begin(begin)
        self._source.publish_until(end)
        self._ticked = time.monotonic()

    def _set_paused(self, is_paused: bool) -> None:
        self._is_paused = is_paused
        self._paused.publish(is_paused)

    # Services.

    def _pause(self, request: Any) -> SetBoolResponse:
        with self._lock:
            if not request.data and self._source.is_over:
                self._go_to(self._source.start)
            self._set_paused(request.data)
            return SetBoolResponse(True, self._state())

    def _answer(self, action: Any) -> TriggerResponse:
        with self._lock:
            try:
                action()
            except ForgeError as error:
                return TriggerResponse(False, str(error))
            return TriggerResponse(True, self._state())

    def _step(self) -> None:
        self._set_paused(True)
        self._source.publish_until(self._source.time_of_next_frame())

    def _go_back_to_now(self) -> None:
        attack = self._attack
        if not attack.trajectory.attacker_id:
            raise ForgeError('there is no attack to go back to: request one with generate_collision')
        now = self._source.time_of_frame(attack.header.stamp)
        self._set_paused(True)
        self._go_back(now)

    def _go_back(self, end: Time) -> None:
        """Publish the last HISTORY s before `end` again; wait until the suite has encoded the newest frame."""
        self._encoded = None
        self._go_to(end, Time.from_sec(max(0.0, end.to_sec() - HISTORY)))
        frames = self._source.frames_until(end)
        if self._scenes.get_num_connections() > 0 and frames:
            wait_until(lambda: [] if self._encoded == frames[-1][1] else ['encoded_scene'], SCENE_TIMEOUT)

    def _answer_seek(self, request: srv.SeekRequest) -> srv.SeekResponse:
        answer = self._answer(lambda: self._seek(request.instant))
        return srv.SeekResponse(answer.success, answer.message)

    def _seek(self, instant: float) -> None:
        """Jump to an instant. A jump forwards publishes all messages in between, so that an attack is tested."""
        if not 0.0 <= instant <= self._source.length:
            raise ForgeError('instant = {:g} is outside the bag: 0 to {:g}'.format(instant, self._source.length))
        end = self._source.start + Duration.from_sec(instant)
        if end < self._source.now:
            self._go_back(end)
        else:
            self._source.publish_until(end)
        self._ticked = time.monotonic()

    def _state(self) -> str:
        return '{} {:.1f} s of {}'.format('paused at' if self._is_paused else 'playing from',
                                          self._source.instant, self._source.path.name)

    # Subscriptions.

    def _receive_attack(self, attack: msg.Attack) -> None:
        self._attack = attack

    def _receive_scene(self, scene: msg.EncodedScene) -> None:
        self._encoded = scene.header.stamp


class Arguments:
    """The private parameters of the node. Raises ForgeError for invalid values."""

    def __init__(self) -> None:
        self.bag = str(rospy.get_param('~bag', ''))
        self.rate = self._positive('rate', 1.0)    # speed relative to the wall clock
        self.delay = self._positive('delay', 1.0)  # s of the wall clock in which subscribers connect
        self.start = self._number('start', 0.0)    # s from the bag's first frame of agents
        self.loop = bool(rospy.get_param('~loop', False))
        self.start_paused = bool(rospy.get_param('~start_paused', False))
        self.wait_for_suite = bool(rospy.get_param('~wait_for_suite', False))
        if not self.bag:
            raise ForgeError('the parameter bag is empty: set it to the path of a bag')

    @classmethod
    def _positive(cls, name: str, default: float) -> float:
        value = cls._number(name, default)
        if not 0.0 < value < float('inf'):
            raise ForgeError('the parameter {} is {!r}, not a number greater than 0'.format(name, value))
        return value

    @staticmethod
    def _number(name: str, default: float) -> float:
        value = rospy.get_param('~' + name, default)
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise ForgeError('the parameter {} is {!r}, not a number'.format(name, value))
        return float(value)

    def check_start(self, source: BagPublisher) -> None:
        """Raise ForgeError if `start` is outside the bag."""
        if not 0.0 <= self.start <= source.length:
            raise ForgeError('the parameter start is {:g}, outside {}: 0 to {:g}'.format(self.start, source.path,
                                                                                    source.length))


def wait_for_suite(missing: Callable[[], List[str]]) -> None:
    """Wait until nothing is missing. If the suite does not start in time, log a warning and return."""
    try:
        wait_until(missing, SUITE_TIMEOUT)
    except NotReady as error:
        rospy.logwarn('plays without the suite: %s', error)


def missing_nodes() -> List[str]:
    """Return descriptions of the topics of the suite without a publisher."""
    graph = Graph()
    topics = set(PUBLISHED) | {published(topic) for topic in MADE_BY_SUITE}
    return ['a publisher of ' + topic for topic in sorted(topics) if not graph.publishers_of(topic)]


def play() -> int:
    """Play the bag until shutdown; return the exit code."""
    try:
        arguments = Arguments()
        source = BagPublisher(arguments.bag)
        arguments.check_start(source)
        if arguments.wait_for_suite:
            wait_for_suite(missing_nodes)
        source.advertise()
        if arguments.wait_for_suite:
            wait_for_suite(source.unconnected)
        time.sleep(arguments.delay)
        PlayerNode(source, arguments.start, arguments.rate, arguments.loop, arguments.start_paused).run()
    except ForgeError as error:
        if not rospy.is_shutdown():
            rospy.logfatal(str(error))
            return 1
    return 0


def main() -> int:
    """Run the node; return the exit code."""
    return run_node('player', play)

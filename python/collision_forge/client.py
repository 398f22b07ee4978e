"""Python client of the collision_forge services and topics."""
import time
from pathlib import Path
from typing import Any, Dict, Iterator, List, Mapping, Optional, Sequence, Union

import rospy
from genpy import SerializationError, Time
from std_srvs.srv import Trigger

from collision_forge import msg, srv
from collision_forge.controls import control_fields, fields_of
from collision_forge.errors import Code, Declined, ForgeError, NotReady, Unavailable
from collision_forge.player import Player
from collision_forge.results import Answer, Attack, PlannerOutcome, PossibleCollision, Report, Scene
from collision_forge.waiting import Graph, Inbox, wait_until

TIMEOUT = 30.0  # s of the wall clock; a call takes a fraction of a second on an idle machine
LOOK = 0.2      # s of the wall clock for the nodes to process a frame; no message reports that they have finished
SERVICES = {'generate_collision': srv.GenerateCollision, 'generate_collisions': srv.GenerateCollisions,
            'list_collisions': srv.ListCollisions, 'test_planner': srv.TestPlanner, 'reset': Trigger}
PUBLISHED = ['encoded_scene', 'attack', 'tested_report', 'injected_agents', 'attack_methods']
Collision = Union[str, PossibleCollision]


class CollisionForge:
    """Client of a running suite, started by `collision_forge.launch` or `replay.launch`.

    Makes this process a ROS node if it is none yet, and waits for the suite; raises NotReady if the suite is missing.
    `timeout`: limit of each wait, s of the wall clock. Names are relative: `ROS_NAMESPACE` and remappings apply.
    Without a player (`play()`) requests use the newest scene, with a player the frame at which it has paused.
    """

    def __init__(self, timeout: float = TIMEOUT) -> None:
        self.timeout = timeout
        self.player: Optional[Player] = None
        self._tested_from = 0  # mark in the tested reports: earlier reports belong to earlier attacks
        if not rospy.core.is_initialized():
            Graph()  # raises if there is no master; init_node() would block
            rospy.init_node('collision_forge_client', anonymous=True, disable_signals=True)
        self._scenes = Inbox('encoded_scene', msg.EncodedScene)
        self._attacks = Inbox('attack', msg.Attack)
        self._reports = Inbox('tested_report', msg.CollisionReport)
        self._methods = Inbox('attack_methods', msg.AttackMethods)
        try:
            wait_until(self._missing_nodes, timeout)
        except NotReady:
            self.close()
            raise

    def close(self) -> None:
        """Close the subscriptions and the player."""
        if self.player is not None:
            self.player.close()
        for inbox in (self._scenes, self._attacks, self._reports, self._methods):
            inbox.close()

    def __enter__(self) -> 'CollisionForge':
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()

    # Readiness.

    def wait_until_ready(self, timeout: Optional[float] = None) -> 'CollisionForge':
        """Wait for the nodes and a first scene; raise NotReady with the missing parts after `timeout` s."""
        wait_until(lambda: self._missing_nodes() + self._missing_scene(), self.timeout if timeout is None else timeout)
        return self

    def missing(self) -> List[str]:
        """Return the parts that are missing for a request; empty: ready."""
        return self._missing_nodes() + self._missing_scene()

    def _missing_nodes(self) -> List[str]:
        graph = Graph()
        return ['the service ' + name for name in SERVICES if not graph.has_service(name)] + [
            'a publisher of ' + topic for topic in PUBLISHED if not graph.publishers_of(topic)]

    def _missing_scene(self) -> List[str]:
        if self._scenes.newest():
            return []
        graph = Graph()
        sources = ['agents', 'lane_map', '/tf'] + (['/clock'] if rospy.get_param('/use_sim_time', False) else [])
        return ['a publisher of ' + topic for topic in sources if not graph.publishers_of(topic)] or [
            'a message on encoded_scene: agents, lane_map and /tf are published; is there a transform map -> base_link '
            'at the stamps of agents?']

    # The scene.

    @property
    def scene(self) -> Scene:
        """The newest scene; waits for the first one."""
        self.wait_until_ready()
        return Scene.of(self._scenes.newest())

    @property
    def methods(self) -> Dict[str, str]:
        """The available methods by name, the default first, each with a one-line description."""
        message = self._first_of(self._methods)
        lines = dict(zip(message.names, message.descriptions))
        return {message.default_method: lines.pop(message.default_method), **lines}

    def _first_of(self, inbox: Inbox) -> Any:
        wait_until(lambda: [] if inbox.newest() else ['a message on ' + inbox.topic], self.timeout)
        return inbox.newest()

    # Requests.

    def generate(self, collision: Collision = '', tta: Optional[float] = None, *, name: str = '', text: str = '',
                 at: Optional[Time] = None, method: str = '', **controls: Any) -> Attack:
        """Request an attack, wait until it is published and return it; raise Declined if the suite rejects it.

        collision: a collision type, or an entry of `possible()`, which reproduces the listed attack. If tta, method,
            at or a control is given too, the listed attacker and manoeuvre are requested with these values.
        tta: time to attack, s from t0; required with a type or name
        name: in place of a type, a scenario of a catalogue, e.g. 'CCRb' or 'CCRb deceleration=4'
        text: in place of a type, the request in English, e.g. 'truck cuts in from the left in 3 s'
        at: stamp of the frame of agents used as t0; by default the frame of the player, else the newest
        controls: see `control_fields()`
        """
        if bool(collision) + bool(name) + bool(text) != 1:
            raise TypeError('generate() needs a collision, a name or a text, and one of them only')
        fields = {**fields_of(controls), 'name': name, 'text': text}
        return self._generate(collision, 0.0 if text and tta is None else tta, at, method, fields, False)

    def adaptive(self, collision: Collision, tta: Optional[float] = None, *, at: Optional[Time] = None,
                 method: str = '', **controls: Any) -> 'AdaptiveAttack':
        """Generate an adaptive attack, with the arguments of `generate()`. Iterate over the result for its updates."""
        mark = self._attacks.mark()
        first = self._generate(collision, tta, at, method, fields_of(controls), True)
        is_first = [same_attack(message, first.message) for message in self._attacks.since(mark)]
        return AdaptiveAttack(self, first, mark + is_first.index(True))  # messages before it end an earlier attack

    def _generate(self, collision: Collision, tta: Optional[float], at: Optional[Time], method: str,
                  controls: Dict[str, Any], adaptive: bool) -> Attack:
        if isinstance(collision, PossibleCollision):
            changed = {name: value for name, value in controls.items() if value != control_fields().get(name, '')}
            if at or tta or method or changed or adaptive:
                own = {'choice': 'new'} if collision.added else {'attacker_id': collision.attacker}
                own.update(manoeuvre=collision.manoeuvre, alternatives=1)
            else:
                own = {'alternative': collision.alternative}
            controls = {**collision.controls, **own, **changed}
            listed = controls.pop('method')
            method = method or listed
            at, tta = at or collision.now, collision.tta if tta is None else tta
            collision = collision.collision_type
        if tta is None:
            raise TypeError('generate() needs tta, the time in s from t0 to contact')
        mark, self._tested_from = self._attacks.mark(), self._reports.mark()
        answer = self._call('generate_collision', stamp=self._stamp(at), collision_type=collision, tta=float(tta),
                            method=method, adaptive=adaptive, **controls)
        attack = Attack.of(answer.attack, answer.alternatives)
        wait_until(lambda: [] if self._attacks.find(lambda message: same_attack(message, answer.attack), mark) else
                   ['the attack on the topic attack'], self.timeout)
        return attack

    def possible(self, collision_types: Sequence[str] = (), ttas: Sequence[float] = (), *, at: Optional[Time] = None,
                 method: str = '', **controls: Any) -> List[PossibleCollision]:
        """Return the feasible collisions by type, then tta; default: all types, ttas of config/requests.yaml."""
        fields = fields_of(controls)
        answer = self._call('list_collisions', **self._each(collision_types, ttas, at, method, fields))
        asked = {**fields, 'method': method}
        return [PossibleCollision.of(message, answer.now, asked) for message in answer.collisions]

    def generate_all(self, collision_types: Sequence[str] = (), ttas: Sequence[float] = (), *,
                     at: Optional[Time] = None, method: str = '', **controls: Any) -> List[Answer]:
        """Run one request per type and tta at one t0 and return all results. Publishes and injects nothing."""
        answer = self._call('generate_collisions',
                            **self._each(collision_types, ttas, at, method, fields_of(controls)))
        return [Answer.of(message) for message in answer.answers]

    def requests(self, every: float, collision_types: Sequence[str] = (), ttas: Sequence[float] = (),
                 **controls: Any) -> Iterator[PossibleCollision]:
        """Play the rest of the bag, pause every `every` s and yield the collisions possible there.

        Frames with too little history are skipped.
        """
        for _ in self._needed_player().every(every):
            try:
                yield from self.possible(collision_types, ttas, **controls)
            except Declined as declined:
                if declined.code != Code.TOO_LITTLE_HISTORY:
                    raise

    def _each(self, collision_types: Sequence[str], ttas: Sequence[float], at: Optional[Time], method: str,
              controls: Dict[str, Any]) -> Dict[str, Any]:
        return {'stamp': self._stamp(at), 'collision_types': list(collision_types), 'ttas': [float(t) for t in ttas],
                'request': msg.CollisionRequest(**controls), 'method': method}

    def _stamp(self, at: Optional[Time]) -> Time:
        """Return the stamp of the player's frame, for which nodes wait; without a player 0: the newest frame."""
        return at or (self.player and self.player.stamp) or Time()

    # The newest attack.

    @property
    def attack(self) -> Optional[Attack]:
        """The newest published attack, or None."""
        message = self._attacks.newest()
        return Attack.of(message) if message and message.trajectory.attacker_id else None

    def tested(self, attack: Attack) -> Report:
        """Return the outcome of the attack of the last `generate()`; a player plays until it is known."""
        player = self.player
        if player is not None and not self._tested(attack):
            end = min(player.instant_of(attack.now) + attack.trajectory[-1].t, player.duration)
            if player.now is None or end > player.now:
                player.until(end)
            time.sleep(LOOK)
        while True:
            report = self._tested(attack)
            if report is not None:
                return report
            if player is not None:
                self._look(player, attack)
            else:
                wait_until(lambda: [] if self._tested(attack) else ['a message on tested_report'], self.timeout)

    def reset(self) -> None:
        """Drop the attack and end its injection."""
        self._call('reset')
        wait_until(lambda: ['an empty attack'] if self.attack else [], self.timeout)

    def _tested(self, attack: Attack) -> Optional[Report]:
        message = self._reports.find(lambda report: (report.header.stamp, report.attacker_id) ==
                                     (attack.now, attack.attacker), self._tested_from)
        return Report.of(message) if message else None

    @staticmethod
    def _look(player: Player, attack: Attack) -> None:
        """Step the player by one frame and give the nodes time to process it."""
        if player.is_at_end:
            raise ForgeError('the bag ends before the test of {!r} has ended'.format(attack))
        player.step()
        time.sleep(LOOK)

    # Planners.

    def test_planner(self, planner: str, attack: Optional[Attack] = None, *, scenario: Union[str, int] = '',
                     parameters: Optional[Mapping[str, float]] = None, attacker_policy: str = '',
                     background: str = '') -> PlannerOutcome:
        """Test a planner in closed loop against an attack in the suite's `recording`, or in a scenario.

        planner: idm, idm_published, pdm, rule_based, rule_based_tuned, torchscript or external (a node of yours; the
            call waits for it)
        attack: default, and with attacker_policy adaptive always, the newest one
        scenario: line number in the scenario file of planner_tester, or a whole line
        parameters: values that replace keys of config/planners.yaml, for example {'pdm.idm.min_gap': 2.0}
        attacker_policy: fixed or adaptive; background: replay or idm
        """
        if planner == 'external':
            wait_until(lambda: [] if Graph().publishers_of('planned_trajectory') else
                       ['a planner that publishes planned_trajectory'], self.timeout)
        fields: Dict[str, Any] = {}
        if attack is not None and attacker_policy != 'adaptive':
            fields = {'trajectory': attack.message.trajectory, 'collision_type': attack.collision_type}
        numbers = [msg.PlannerParameter(name, float(value)) for name, value in (parameters or {}).items()]
        answer = self._call('test_planner', planner=planner, scenario=str(scenario), parameters=numbers,
                            attacker_policy=attacker_policy, background=background, **fields)
        return PlannerOutcome.of(answer.outcome)

    # Bags.

    def play(self, bag: Union[str, Path]) -> Player:
        """Return a new player of a bag, in lock step with this client; closes the previous one."""
        if self.player is not None:
            self.player.close()
        self.player = Player(bag, self._scenes, self.timeout)
        return self.player

    def _needed_player(self) -> Player:
        if self.player is None:
            raise ForgeError('no bag is open: call play() first')
        return self.player

    def _call(self, name: str, /, **fields: Any) -> Any:
        service = SERVICES[name]
        try:
            answer = rospy.ServiceProxy(name, service)(service._request_class(**fields))
        except (rospy.ServiceException, rospy.ROSException) as error:
            raise Unavailable('{}: {}'.format(name, error)) from error
        except SerializationError as error:
            raise ForgeError('{}: a value does not fit its message field: {}'.format(name, error)) from error
        code = getattr(answer, 'code', Code.OK)
        if code != Code.OK:
            raise Declined(code, answer.message)
        return answer

    def __repr__(self) -> str:
        return '<CollisionForge at {}: {}>'.format(
            rospy.resolve_name('generate_collision'), self.player or 'no player')


class AdaptiveAttack:
    """An adaptive attack. Iterating yields its first plan, then each update, until its test has ended.

    `report` then holds the measured result. With a player, each iteration plays up to the next frame of agents.
    """

    def __init__(self, forge: CollisionForge, first: Attack, mark: int) -> None:
        self.first = first
        self.newest = first
        self.report: Optional[Report] = None
        self._forge = forge
        self._mark = mark
        self._changed = time.monotonic()

    def __iter__(self) -> Iterator[Attack]:
        yield from self._published()
        while self.report is None:
            if self._forge.player is not None:
                self._forge._look(self._forge.player, self.first)
            else:
                self._wait_for_news()
            self.report = self._forge._tested(self.first)
            yield from self._published()

    def _wait_for_news(self) -> None:
        mark = self._forge._attacks.mark
        wait_until(lambda: [] if mark() > self._mark or self._forge._tested(self.first) else
                   ['a change of the attack or its test'], self._forge.timeout)

    def _published(self) -> Iterator[Attack]:
        mark = self._forge._attacks.mark()
        for message in self._forge._attacks.since(self._mark)[:mark - self._mark]:
            if not same_attack(message, self.first.message):
                raise ForgeError('another attack replaced {!r}'.format(self.first))
            self.newest = Attack.of(message)
            yield self.newest
        self._mark = mark

    def __repr__(self) -> str:
        return '<AdaptiveAttack: {!r}>'.format(self.newest)


def same_attack(one: Any, other: Any) -> bool:
    """Return true if both messages have the same t0, type and attacker; the trajectory may differ."""
    return (one.header.stamp, one.pattern.collision_type, one.trajectory.attacker_id) == (
        other.header.stamp, other.pattern.collision_type, other.trajectory.attacker_id)

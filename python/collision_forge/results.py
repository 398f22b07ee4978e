"""Results of the suite as plain data.

SI units and radians, in the frame `map`; the pose of a vehicle is the middle of its box. `now` is the stamp of the
frame of agents at t0, on the recording's clock. All other times are in s from t0. `message` is the ROS message of a
result.
"""
import math
from dataclasses import dataclass, field, fields
from typing import Any, Dict, Optional, Tuple

from genpy import Time

from collision_forge.errors import Code
from collision_forge.msg import Agent as AgentMessage

CLASSES: Dict[int, str] = {value: name.lower() for name, value in vars(AgentMessage).items()
                           if name.isupper() and isinstance(value, int)}


def raw() -> Any:
    """Return a field for the message, excluded from repr and comparison."""
    return field(repr=False, compare=False)


class Result:
    """Base class with a repr of its fields, numbers to three decimals."""

    def __repr__(self) -> str:
        shown = ((entry.name, getattr(self, entry.name)) for entry in fields(self) if entry.repr)
        return '{}({})'.format(type(self).__name__, ', '.join(
            '{}={!r}'.format(name, round(value, 3) if isinstance(value, float) else value) for name, value in shown))


@dataclass(frozen=True, repr=False)
class Pose(Result):
    x: float    # m
    y: float    # m
    yaw: float  # rad, counter-clockwise from +x

    @classmethod
    def of_2d(cls, message: Any) -> 'Pose':
        """Return the pose of a geometry_msgs/Pose2D."""
        return cls(message.x, message.y, message.theta)

    @classmethod
    def of_3d(cls, message: Any) -> 'Pose':
        """Return the pose in the plane of a geometry_msgs/Pose."""
        turn = message.orientation
        yaw = math.atan2(2.0 * (turn.w * turn.z + turn.x * turn.y), 1.0 - 2.0 * (turn.y ** 2 + turn.z ** 2))
        return cls(message.position.x, message.position.y, yaw)


@dataclass(frozen=True, repr=False)
class Point(Result):
    """One sample of a vehicle's motion."""

    t: float             # s from t0
    pose: Pose
    speed: float         # m/s along the heading
    acceleration: float  # m/s2 along the heading
    curvature: float     # 1/m, positive to the left

    @classmethod
    def of(cls, message: Any, now: Time) -> 'Point':
        return cls(seconds(now, message.stamp), Pose.of_3d(message.pose), message.speed, message.acceleration,
                   message.curvature)


def seconds(now: Time, stamp: Time) -> float:
    """Return the time from t0 to a stamp, s."""
    return float((stamp - now).to_sec())


@dataclass(frozen=True, repr=False)
class Effect(Result):
    """Effect of a crash on one party and its occupants or rider."""

    delta_v: float          # m/s, change of velocity of the centre of mass
    force_from: float       # rad, where the force comes from, counter-clockwise from the party's heading
    yaw_rate_change: float  # rad/s
    mais2: float            # probability of an injury of MAIS 2 or more, [0, 1]
    mais3: float            # probability of an injury of MAIS 3 or more, [0, 1]
    curve: str              # published injury curve; empty for a party without people
    least_class: int        # ISO 26262 S0 to S3, by the most lenient published bounds
    most_class: int         # the same by the strictest published bounds

    @classmethod
    def of(cls, message: Any) -> 'Effect':
        return cls(*(getattr(message, entry.name) for entry in fields(cls)))


def avoiders(message: Any) -> Tuple[str, ...]:
    """Return the careful drivers of a message that avoid the attack."""
    return tuple(drive.driver for drive in message.careful_drivers if drive.avoids)


@dataclass(frozen=True, repr=False)
class Conditions(Result):
    """Quantities of an attack that a request can constrain."""

    from_side: str          # side from which the attacker came, left or right
    attacker_speed: float   # m/s at contact
    deceleration: float     # m/s2, mean over the last 0.5 s before the contact
    gap: float              # m at t0
    headway: float          # s at t0
    lateral_speed: float    # m/s, across the ego's heading at contact
    impact_location: float  # share of the ego's width, 0 at its left edge
    departure_time: float   # s after t0; -1: it moves at t0 or stands at the contact
    visible_for: float      # s before contact from which on the ego sees the attacker; at most the time since t0
    hidden_by: str          # parked_vehicle or leader: what hid it until then; empty: neither
    hidden_by_id: str       # agent that hid it; empty: visible since t0

    @classmethod
    def of(cls, message: Any) -> 'Conditions':
        return cls(*(getattr(message, entry.name) for entry in fields(cls)))


@dataclass(frozen=True, repr=False)
class Contact(Result):
    """The first touch of ego and attacker."""

    t: float                 # s from t0
    ego: Pose
    attacker: Pose
    relative_heading: float  # rad, attacker's yaw minus the ego's, (-pi, pi]
    ego_side: str            # front, rear, left or right
    attacker_side: str
    impact_speed: float      # m/s, norm of the relative velocity
    overlap: float           # share of the ego's side that the attacker covers, [0, 1]
    ego_effect: Effect       # severity for the ego
    attacker_effect: Effect
    conditions: Conditions


@dataclass(frozen=True, repr=False)
class Report:
    """Verification result of an attacker trajectory: predicted, or measured in the recording (tested)."""

    now: Time
    attacker: str
    verified: bool              # contact as requested, all limits kept, no earlier contact with other agents
    contact: Optional[Contact]  # None: no contact with the ego
    type_kept: bool
    on_time: bool
    limits_kept: bool
    broken_limit: str           # name, value and limit of the worst violation; empty: none
    touched_before: str         # id of the agent that the attacker touches before the ego; empty: none
    off_road_share: float       # mean share of its box off the drivable area, [0, 1]
    manoeuvre: str              # manoeuvre of the attacker; empty without contact
    manoeuvre_begin: Optional[float]  # s from t0
    believable: bool            # plausible: drives like recorded drivers until its manoeuvre
    unbelievable: str           # reason if not plausible
    confidence: float           # share of predicted ego futures in which it is verified, [0, 1]; 0 if tested
    decision: str               # last decision of an adaptive attacker
    avoided_by: Tuple[str, ...]  # careful drivers that avoid the attack in the recording; empty if it is unknown
    message: Any = raw()

    @classmethod
    def of(cls, message: Any) -> 'Report':
        now = message.header.stamp
        contact = None
        if message.contact:
            contact = Contact(seconds(now, message.contact_time), Pose.of_2d(message.ego_at_contact),
                              Pose.of_2d(message.attacker_at_contact), message.relative_heading, message.ego_side,
                              message.attacker_side, message.impact_speed, message.overlap,
                              Effect.of(message.ego_effect), Effect.of(message.attacker_effect),
                              Conditions.of(message.conditions))
        return cls(now, message.attacker_id, message.verified, contact, message.type_kept, message.on_time,
                   message.limits_kept, message.broken_limit, message.first_other_id, message.off_road_share,
                   message.manoeuvre if contact else '', seconds(now, message.manoeuvre_begin) if contact else None,
                   message.believable, message.unbelievable, message.confidence, message.decision, avoiders(message),
                   message)

    def __repr__(self) -> str:
        return '<Report {}: {}>'.format('verified' if self.verified else 'not verified', self.summary())

    def summary(self) -> str:
        if self.contact is None:
            return 'no contact'
        return '{} after {:.2f} s on the {} at {:.1f} m/s'.format(
            self.manoeuvre, self.contact.t, self.contact.ego_side, self.contact.impact_speed)


@dataclass(frozen=True, repr=False)
class Attack:
    """A generated attack."""

    now: Time
    collision_type: str     # as in srv/GenerateCollision.srv, without any
    attacker: str           # id of its agent
    attacker_class: str     # car, truck, ...
    added: bool             # not a recorded agent
    trajectory: Tuple[Point, ...]  # from t0 to after the contact
    report: Report          # predicted
    method: str
    adaptive: bool          # the attacker replans
    phase: str              # adaptive: attacking, committed or driving_on
    decision: str           # last decision, for people
    plans: int              # number of decisions; 0 if not adaptive
    alternatives: Tuple['Attack', ...]  # by falling confidence
    message: Any = raw()

    @classmethod
    def of(cls, message: Any, alternatives: Any = ()) -> 'Attack':
        driven, now = message.trajectory, message.header.stamp
        return cls(now, message.pattern.collision_type, driven.attacker_id, CLASSES[driven.agent_class], driven.added,
                   tuple(Point.of(point, now) for point in driven.points), Report.of(message.report), message.method,
                   message.adaptive, message.phase, message.decision, message.plans,
                   tuple(cls.of(other) for other in alternatives), message)

    def __repr__(self) -> str:
        state = '; {}: {}'.format(self.phase, self.decision) if self.adaptive else ''
        return '<Attack {} by {}{} {:.8}: {}, confidence {:.0f} %{}>'.format(
            self.collision_type, 'added ' if self.added else '', self.attacker_class, self.attacker,
            self.report.summary(), 100.0 * self.report.confidence, state)


@dataclass(frozen=True, repr=False)
class PossibleCollision(Result):
    """A feasible collision with its predicted contact; an argument of `forge.generate()`."""

    now: Time = field(repr=False)
    collision_type: str
    tta: float            # s from t0, for the request
    alternative: int      # number of the attack in the response, from 1
    attacker: str         # id of the agent; for an added vehicle its new id
    attacker_class: str
    added: bool           # not a recorded agent
    manoeuvre: str
    confidence: float     # [0, 1]
    contact_after: float  # s from t0, predicted
    impact_speed: float   # m/s, predicted
    controls: Dict[str, Any] = field(repr=False, compare=False)  # controls of the request
    message: Any = raw()

    @classmethod
    def of(cls, message: Any, now: Time, controls: Dict[str, Any]) -> 'PossibleCollision':
        return cls(now, message.collision_type, message.tta, message.alternative, message.attacker_id,
                   message.attacker_class, message.added, message.manoeuvre, message.confidence, message.contact_after,
                   message.impact_speed, controls, message)


@dataclass(frozen=True, repr=False)
class Answer(Result):
    """The result of one of several requests."""

    collision_type: str
    tta: float                # s from t0
    code: Code
    reason: str               # reason of rejection; empty with OK
    attack: Optional[Attack]  # None: rejected
    message: Any = raw()

    @classmethod
    def of(cls, message: Any) -> 'Answer':
        code = Code(message.code)
        attack = Attack.of(message.attack, message.alternatives) if code == Code.OK else None
        return cls(message.collision_type, message.tta, code, message.message, attack, message)


@dataclass(frozen=True, repr=False)
class PlannerContact(Result):
    """First contact of the ego driven by a planner."""

    t: float                 # s from t0
    other: str               # id of the touched agent
    is_attacker: bool
    collision_type: str      # type of the contact; empty: none of the types
    relative_heading: float  # rad, yaw of the other agent minus the ego's, (-pi, pi]
    ego_side: str            # front, rear, left or right
    other_side: str
    impact_speed: float      # m/s, norm of the relative velocity
    ego_effect: Effect       # severity for the ego
    other_effect: Effect
    cause: str               # stopped_ego, stopped_other, rear, front or lateral
    at_fault: bool           # the ego is at fault


@dataclass(frozen=True, repr=False)
class PlannerOutcome:
    """Result of a planner's drive through an attack."""

    now: Time
    planner: str
    attacker: str
    failure: str                       # failure code that ended the test, such as error or off_map; empty: none
    failure_reason: str
    duration: float                    # s from t0 to the contact, the failure or the end of the attacker's trajectory
    contact: Optional[PlannerContact]  # None: no contact
    avoided_by: Tuple[str, ...]        # careful drivers that avoid the attacker on the planner's path
    avoidable: bool                    # an evasive manoeuvre was found; False is no proof
    last_manoeuvre: str                # evasive manoeuvre that can start latest; empty unless avoidable
    last_moment: Optional[float]       # s from t0, its latest start
    max_braking: float                 # m/s2
    off_road_share: float              # mean share of the ego's box off the drivable area, [0, 1]
    progress: float                    # m along the route
    recorded_progress: float           # m, by the recorded ego in the same time
    nuplan: Dict[str, float]           # nuPlan's closed-loop `score` and its parts, [0, 1]
    driven: Tuple[Point, ...]          # trajectory of the ego, from t0
    message: Any = raw()

    @classmethod
    def of(cls, message: Any) -> 'PlannerOutcome':
        now = message.header.stamp
        contact = None
        if message.collided:
            contact = PlannerContact(seconds(now, message.contact_time), message.other_id, message.is_attacker,
                                     message.collision_type, message.relative_heading, message.ego_side,
                                     message.other_side, message.impact_speed, Effect.of(message.ego_effect),
                                     Effect.of(message.other_effect), message.cause, message.at_fault)
        nuplan = {name[len('nuplan_'):]: getattr(message, name) for name in message.__slots__
                  if name.startswith('nuplan_')}
        return cls(now, message.planner, message.attacker_id, '' if message.failure == 'none' else message.failure,
                   message.failure_message, message.duration, contact, avoiders(message), message.avoidable,
                   message.last_manoeuvre if message.avoidable else '',
                   seconds(now, message.last_moment) if message.avoidable else None, message.max_braking,
                   message.off_road_share, message.progress, message.recorded_progress, nuplan,
                   tuple(Point.of(point, now) for point in message.driven), message)

    @property
    def hit(self) -> bool:
        """Return True if the attacker touched the ego."""
        return self.contact is not None and self.contact.is_attacker

    def __repr__(self) -> str:
        return '<PlannerOutcome {}: {}>'.format(self.planner, self.summary())

    def summary(self) -> str:
        if self.failure:
            return 'failed ({}): {}'.format(self.failure, self.failure_reason)
        if self.contact is None:
            return 'no contact in {:.1f} s'.format(self.duration)
        return 'touches {} {:.8} after {:.2f} s at {:.1f} m/s, {}'.format(
            'the attacker' if self.hit else 'the agent', self.contact.other, self.contact.t,
            self.contact.impact_speed, self._avoidance())

    def _avoidance(self) -> str:
        """Return the text about evasive manoeuvres."""
        if self.last_moment is None:
            return 'not known to be avoidable'
        at_once = self.last_moment < 1e-6  # s
        if self.last_manoeuvre != 'keeping':
            when = 'at once' if at_once else 'up to {:.1f} s after t0'.format(self.last_moment)
            how = 'braking and steering' if self.last_manoeuvre == 'both' else self.last_manoeuvre
            return 'avoidable {} by {}'.format(when, how)
        if self.message.attacker_policy != 'adaptive':
            return 'avoidable by driving as recorded'
        return 'avoidable by keeping its speed' + ('' if at_once else ' from {:.1f} s after t0 on'.format(self.last_moment))


@dataclass(frozen=True, repr=False)
class Agent(Result):
    """An agent in the scene at t0."""

    id: str
    agent_class: str  # car, truck, ...
    length: float     # m
    width: float      # m
    pose: Pose
    speed: float      # m/s

    @classmethod
    def of(cls, track: Any) -> 'Agent':
        newest = track.states[-1]
        return cls(track.id, CLASSES[track.agent_class], track.size.x, track.size.y, Pose.of_2d(newest.pose),
                   math.hypot(newest.velocity_x, newest.velocity_y))


@dataclass(frozen=True, repr=False)
class Scene:
    """The observed scene at t0."""

    now: Time
    ego: Agent
    agents: Tuple[Agent, ...]  # agents present at t0
    message: Any = raw()

    @classmethod
    def of(cls, message: Any) -> 'Scene':
        """Return the scene of an EncodedScene."""
        now = message.header.stamp
        present = [track for track in message.snapshot.agents if track.states and track.states[-1].stamp == now]
        return cls(now, Agent.of(message.snapshot.ego), tuple(Agent.of(track) for track in present), message)

    def __repr__(self) -> str:
        return '<Scene at {:.1f} s: ego at {:.1f} m/s, {} agents>'.format(
            self.now.to_sec(), self.ego.speed, len(self.agents))

"""Random valid and invalid requests of all services for scripts/soak, reproducible by a seed."""
import copy
import math
import random

import rospy

from collision_forge import srv
from collision_forge.msg import AttackerTrajectory, CollisionRequest, PlannerParameter, TrajectoryPoint

TYPES = ['lane_change', 'opposite_direction', 'rear_end', 'junction_crossing', 'ltap', 'sideswipe_same_direction',
         'angle_same_direction', 'angle_opposite_direction', 'any']
PLANNERS = ['idm', 'pdm', 'rule_based']
NUMBERS = [math.nan, math.inf, -math.inf, -1.0, 0.0, 1e300, 1e-308]
TEXTS = ['', ' ', 'nobody', '../x', '\x1b[2J', 'x' * 10000, '0.' + 400 * '0' + '1']
BAD_FIELDS = [('collision_type', TEXTS), ('tta', NUMBERS), ('attacker_id', TEXTS[1:]), ('mode', TEXTS[1:]),
              ('choice', TEXTS[1:]), ('manoeuvre', TEXTS[1:]), ('attacker_class', ['pedestrian'] + TEXTS[1:]),
              ('ego_side', TEXTS[1:]), ('min_overlap', NUMBERS), ('max_impact_speed', NUMBERS), ('max_gap', NUMBERS),
              ('turning', TEXTS[1:]), ('from_side', TEXTS[1:]), ('hidden_by', TEXTS[1:]), ('limits', TEXTS[1:]),
              ('believable', TEXTS[1:]), ('alternatives', [17, 2 ** 32 - 1])]
SCENARIOS = TEXTS[1:] + ['1', '{}', '{"format":', '[' * 5000, '{"format": 0.' + 348 * '0' + '1}']


class Requests:
    """Draws requests. `scene` and `attack` are functions that return the newest snapshot and attack, or None before."""

    def __init__(self, seed, scene, attack):
        self.random = random.Random(seed)
        self.scene = scene
        self.attack = attack
        self.predicted = None

    def take(self, request, answer):
        """Keep predicted patterns for later requests of realize_trajectory."""
        if isinstance(answer, srv.PredictPatternResponse) and answer.patterns:
            self.predicted = request, answer

    def draw(self):
        """Return the name of a service and a request."""
        name, make = self.random.choices(
            [('generate_collision', self.generate), ('generate_collisions', self.generate_each),
             ('list_collisions', self.list_possible), ('predict_pattern', self.predict),
             ('realize_trajectory', self.realize), ('test_planner', self.test)], [60, 4, 4, 14, 14, 4])[0]
        return name, make()

    def is_bad(self):
        return self.random.random() < 0.3

    def fill(self, request):
        """Fill a request that has the fields of CollisionRequest; some requests get an invalid value."""
        choose = self.random.choice
        request.collision_type, request.tta = choose(TYPES), choose([1.0, 2.0, 4.0, 6.0])
        request.seed = self.random.randrange(2 ** 32)
        request.mode, request.believable = choose(['', 'history', 'replay']), choose(['', 'true', 'false', 'false'])
        request.choice = choose(['', 'existing', 'existing', 'new'])
        if self.is_bad():
            field, values = choose(BAD_FIELDS)
            setattr(request, field, choose(values))
        return request

    def generate(self):
        request = self.fill(srv.GenerateCollisionRequest())
        request.adaptive = self.random.random() < 0.2
        if request.adaptive and not self.is_bad():
            request.mode = 'history'
        if self.random.random() < 0.1:
            request.alternatives = 3
        if self.random.random() < 0.05:
            request.method = self.random.choice(TEXTS[1:] + ['nominal'])
        return request

    def for_each(self, request):
        single = self.fill(CollisionRequest())
        request.collision_types, request.ttas = [single.collision_type], [single.tta, 4.0]
        single.collision_type, single.tta = '', 0.0
        request.request = single
        return request

    def generate_each(self):
        return self.for_each(srv.GenerateCollisionsRequest())

    def list_possible(self):
        return self.for_each(srv.ListCollisionsRequest())

    def snapshot(self):
        """Return the newest snapshot, for invalid requests with a wrong number; sometimes an empty one."""
        scene = copy.deepcopy(self.scene())
        if scene is None or self.random.random() < 0.05:
            return srv.PredictPatternRequest().scene
        tracks = [scene.ego] + scene.agents
        if self.is_bad():
            track = self.random.choice(tracks)
            number = self.random.choice(NUMBERS)
            if track.states and self.random.random() < 0.5:
                self.random.choice(track.states).pose.x = number
            else:
                track.size.x = number
        return scene

    def predict(self):
        return srv.PredictPatternRequest(scene=self.snapshot(), request=self.fill(CollisionRequest(mode='history')))

    def realize(self):
        """Return a request with predicted patterns, some altered; with none before the first prediction."""
        if self.predicted is None:
            return srv.RealizeTrajectoryRequest(scene=self.snapshot(), request=self.fill(CollisionRequest()))
        request, answer = copy.deepcopy(self.predicted)
        if self.is_bad():
            answer.patterns[0].attacker_offset.x = self.random.choice(NUMBERS)
        if self.is_bad():
            request.scene = self.snapshot()
        return srv.RealizeTrajectoryRequest(request.scene, request.request, answer.patterns, answer.future, False)

    def test(self):
        request = srv.TestPlannerRequest(planner=self.random.choice(PLANNERS))
        attack = self.attack()
        if self.is_bad():
            request.scenario = self.random.choice(SCENARIOS)
        elif attack is not None:
            request.trajectory, request.collision_type = self.trajectory(attack), attack.pattern.collision_type
        if self.is_bad():
            request.planner = self.random.choice(TEXTS[1:])
        elif self.is_bad():
            request.parameters = [PlannerParameter('idm.standard.min_gap', self.random.choice(NUMBERS))]
        return request

    def trajectory(self, attack):
        trajectory = copy.deepcopy(attack.trajectory)
        if not self.is_bad():
            return trajectory
        if self.random.random() < 0.3:
            return AttackerTrajectory(attacker_id='x', points=[TrajectoryPoint(stamp=rospy.Time(1))])
        point = self.random.choice(trajectory.points)
        point.pose.position.x = self.random.choice(NUMBERS)
        return trajectory

#!/usr/bin/python3
"""usage: tutorial_tests.py SCENARIOS: test the planner `external` in each attack of a scenario file; count the hits."""
import json
import sys

import rospy
from collision_forge.results import PlannerOutcome
from collision_forge.srv import TestPlanner

hits = tests = 0
rospy.init_node('tutorial_tests')
rospy.wait_for_service('test_planner')
test_planner = rospy.ServiceProxy('test_planner', TestPlanner)
for number, line in enumerate(open(sys.argv[1]), 1):
    scenario = json.loads(line)
    for policy in ['fixed', 'adaptive'] if scenario['attacker'] else []:
        response = test_planner(planner='external', scenario=str(number), attacker_policy=policy, background='idm')
        outcome = PlannerOutcome.of(response.outcome)
        hits, tests = hits + outcome.hit, tests + 1
        print(number, scenario['report']['manoeuvre'], policy + ':', outcome.summary())
print('hit in', hits, 'of', tests, 'tests')

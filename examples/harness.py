"""Fails if an attacker hits the planner although the crash was avoidable; see docs/python.md.

Two environment variables select the test:

- PLANNER: a planner of the suite, or the command that starts your node (docs/planners.md#your-planner).
- ATTACKER_POLICY: `fixed` attackers follow their trajectory, `adaptive` attackers replan against the planner.
"""
import os
import shlex

import pytest
from collision_forge import Declined
from collision_forge.suite import Program

PLANNER = os.environ.get('PLANNER', 'idm')
ATTACKER_POLICY = os.environ.get('ATTACKER_POLICY', 'fixed')
TYPES = ['lane_change', 'opposite_direction', 'rear_end', 'junction_crossing', 'ltap']
TESTED = []


@pytest.fixture(scope='module')
def planner(forge_suite, tmp_path_factory):
    if ' ' not in PLANNER:
        yield PLANNER
        return
    with Program(shlex.split(PLANNER), tmp_path_factory.mktemp('planner') / 'planner.log'):
        yield 'external'


@pytest.mark.parametrize('now', [4.0, 8.0, 12.0])
@pytest.mark.parametrize('collision_type', TYPES)
def test_is_not_hit_if_avoidable(forge, planner, collision_type, now):
    forge.player.until(now)
    try:
        attack = forge.generate(collision_type, tta=4.0, mode='replay')
    except Declined as declined:
        pytest.skip(str(declined))
    # Other agents brake for the planner (idm), so that the attacker is the first to reach it.
    outcome = forge.test_planner(planner, attack, attacker_policy=ATTACKER_POLICY, background='idm')
    TESTED.append(outcome)
    if outcome.failure or (outcome.hit and outcome.avoidable):
        pytest.fail(outcome.summary(), pytrace=False)


def test_something_was_tested():
    assert TESTED, 'no collision is possible in these bags'

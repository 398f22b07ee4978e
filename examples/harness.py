"""Fails where a planner is hit by a crash that it could have avoided; docs/python.md tells how to run it.

PLANNER in the environment: a planner of the suite, or the command that starts one of your own
(docs/planners.md#an-external-planner).
"""
import os
import shlex

import pytest
from collision_forge import Declined
from collision_forge.suite import Program

PLANNER = os.environ.get('PLANNER', 'idm')
TYPES = ['lane_change', 'opposite_direction', 'rear_end', 'junction_crossing', 'ltap']
TESTED = []


@pytest.fixture(scope='module')
def planner(forge_suite, tmp_path_factory):
    if ' ' not in PLANNER:
        yield PLANNER
        return
    with Program(shlex.split(PLANNER), tmp_path_factory.mktemp('planner') / 'planner.log'):
        yield 'external'


@pytest.mark.parametrize('now', [2.0, 6.0, 10.0])
@pytest.mark.parametrize('collision_type', TYPES)
def test_is_not_hit_where_it_can_escape(forge, planner, collision_type, now):
    forge.player.until(now)
    try:
        attack = forge.generate(collision_type, tta=4.0, mode='replay')
    except Declined as declined:
        pytest.skip(str(declined))
    TESTED.append(forge.test_planner(planner, attack))
    assert not TESTED[-1].failure and not (TESTED[-1].hit and TESTED[-1].avoidable), TESTED[-1].summary()


def test_something_was_tested():
    assert TESTED, 'no collision is possible in these bags'

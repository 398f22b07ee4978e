"""pytest fixtures that start the suite, play a bag in lock step, and shut the suite down.

Loaded by `pytest -p collision_forge.pytest_plugin`, or by `pytest_plugins = ['collision_forge.pytest_plugin']` in the
top-level conftest.py. The bags come from `--forge-bag` or from your own fixture `forge_bag`.
"""
import logging
from pathlib import Path
from typing import Dict, Iterator

import pytest
import rospy

from collision_forge.client import CollisionForge
from collision_forge.suite import Master, Suite

TIMEOUT = 60.0  # s of the wall clock for the suite to start


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.getgroup('collision_forge').addoption(
        '--forge-bag', action='append', default=[], metavar='BAG', type=Path,
        help='bag that tests with the fixture forge play; may be given several times')


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line('filterwarnings', 'ignore:notifyAll:DeprecationWarning')  # in rospy


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    bags = metafunc.config.getoption('--forge-bag')
    if bags and 'forge_bag' in metafunc.fixturenames:
        metafunc.parametrize('forge_bag', bags, ids=[bag.stem for bag in bags], scope='module')


@pytest.fixture(scope='module')
def forge_bag() -> Path:
    """Return the bag to play, one for each --forge-bag."""
    raise pytest.UsageError('give --forge-bag, or define a fixture forge_bag')


@pytest.fixture(scope='module')
def forge_arguments() -> Dict[str, str]:
    """Return arguments of collision_forge.launch, such as {'config_dir': '/a/folder'}; by default none."""
    return {}


@pytest.fixture(scope='session')
def forge_master(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Master]:
    """Start a roscore on a free port; programs started by tests use it, too."""
    with Master(tmp_path_factory.mktemp('master'), TIMEOUT) as master:
        yield master
        rospy.signal_shutdown('the tests are over')


@pytest.fixture(scope='module')
def forge_suite(forge_master: Master, tmp_path_factory: pytest.TempPathFactory, forge_bag: Path,
                forge_arguments: Dict[str, str]) -> Iterator[Suite]:
    """Start the suite, with the bag as its recording."""
    with Suite(tmp_path_factory.mktemp('suite'), forge_bag, **forge_arguments) as suite:
        yield suite


@pytest.fixture
def forge(forge_suite: Suite, forge_bag: Path) -> Iterator[CollisionForge]:
    """Return a client without an attack; its `player` has opened the bag and published nothing yet."""
    forge_suite.check()
    with CollisionForge(TIMEOUT) as client:
        logging.getLogger('rospy').setLevel(logging.WARNING)  # hides connection messages
        client.reset()
        client.play(forge_bag)
        yield client

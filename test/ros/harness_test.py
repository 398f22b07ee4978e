#!/usr/bin/python3
"""examples/harness.py, as docs/python.md runs it: it fails for a planner with an avoidable hit."""
import contextlib
import os
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import road

GOOD, BAD = 'scene-0001', 'scene-0007'  # idm: hit in a lane change only; hit several times


class HarnessTest(road.RoadTest):
    SCENES = [GOOD, BAD]

    def harness(self, scene, *arguments, planner='idm'):
        """Return the exit code, and the outcome of each case by name."""
        junit = self.path('junit.xml')
        result = subprocess.run(
            ['/usr/bin/python3', '-m', 'pytest', '-p', 'no:cacheprovider', '-p', 'collision_forge.pytest_plugin',
             road.PACKAGE_FOLDER / 'examples' / 'harness.py', '--forge-bag', self.bag(scene),
             '--junitxml={}'.format(junit), *arguments], env=dict(os.environ, PLANNER=planner), stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, universal_newlines=True, timeout=road.TIMEOUT, check=False)
        self.assertTrue(junit.exists(), result.stdout)
        return result.returncode, {case.get('name'): [(entry.tag, entry.get('message')) for entry in case]
                                   for case in ElementTree.parse(str(junit)).iter('testcase')}

    def test_succeeds_where_nobody_is_hit(self):
        code, cases = self.harness(GOOD, '-k', 'not lane_change')
        self.assertEqual(code, 0, cases)
        self.assertEqual(cases['test_something_was_tested'], [])
        self.assertEqual(cases['test_is_not_hit_if_avoidable[scene-0001-rear_end-8.0]'], [])

    def test_fails_where_the_planner_is_hit(self):
        code, cases = self.harness(BAD, '-k', 'lane_change or something')
        self.assertEqual(code, 1, cases)
        failures = [message for entries in cases.values() for tag, message in entries if tag == 'failure']
        self.assertGreater(len(failures), 0)
        for message in failures:
            self.assertRegex(message, 'touches the attacker .* avoidable .*by')

    def test_drives_a_planner_in_a_node_of_its_own(self):
        code, cases = self.harness(GOOD, '-k', 'rear_end or something',
                                   planner='rosrun collision_forge external_planner.py')
        self.assertEqual(code, 0, cases)

    def test_leaves_nothing_running(self):
        self.harness(BAD, '-k', '(lane_change and 8.0) or something')
        for command in Path('/proc').glob('[0-9]*/cmdline'):
            with contextlib.suppress(OSError):  # of processes that have just ended
                self.assertNotIn(str(self.bag(BAD)), command.read_text(errors='replace'))


if __name__ == '__main__':
    road.main()
